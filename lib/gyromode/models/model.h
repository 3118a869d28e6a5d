#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/elements/boom_point.h"
#include "gyromode/models/parameters.h"
#include "gyromode/models/reports.h"
#include "gyromode/modes/count.h"
#include "gyromode/modes/modes.h"
#include "gyromode/structure/ignored_couplings.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// What is asked of the modes of a model, of whatever kind.
struct ModesRequest {
  ModesOptions options;         ///< `method` is left at automatic: it follows from the name below
  std::string method = "auto";  ///< a name of --method; each kind knows its own
  Labels keep;                  ///< coordinates to see the modes from; empty: all
};

/// A motion over time that is asked for.
struct MotionRequest {
  State initial;                  ///< q and q̇ at t = 0, n each
  std::vector<Force> forces;
  std::vector<BoomPoint> points;  ///< places on the booms of a spacecraft whose displacement is wanted too
  Vector times;                   ///< s, ≥ 0, ascending
  bool rates = false;             ///< velocities are to be written as well
  Progress progress;
};

/// A response at steady frequencies that is asked for.
struct FrequencyRequest {
  Vector amplitude;  ///< f of f e^{jωt}, n
  Vector grid;       ///< rad per unit of time, ascending
  Progress progress;
};

/// A kind of model: what it says of itself, and what it answers. Questions that a kind has no answer to throw NotApplicable, with what to use instead.
class ModelKind {
 public:
  virtual ~ModelKind() = default;

  virtual Index size() const = 0;
  virtual const Labels& labels() const = 0;
  /// For people, after the number of coordinates: "M, G, K in turning axes".
  virtual std::string_view in_words() const = 0;
  /// Whether H depends on ω by more than powers: there may be infinitely many modes.
  virtual bool transcendental() const { return false; }
  virtual bool finite() const { return true; }

  virtual ModesResult modes(const ModesRequest& request) const = 0;
  virtual CountResult count(const Window& window) const = 0;
  /// The modes that a verdict on stability needs, and no more.
  virtual ModesResult verdict(bool with_shapes) const;
  virtual StabilityReport stability() const;
  /// `at`: also H there, rad per unit of time.
  virtual StructureReport structure(std::optional<double> at) const = 0;
  /// Throws NotApplicable unless it has displacements and velocities that move over time.
  virtual void require_motion() const;
  virtual ResponseReport response(const MotionRequest& request) const;
  virtual FrequencyReport frequency_response(const FrequencyRequest& request) const;

  /// The numbers it is made of, those worth listing; further ones may be named.
  virtual std::vector<Parameter> parameters() const { return {}; }
  /// The first number that a key names ([*] for every item); nothing where it names none.
  virtual std::optional<Parameter> parameter(std::string_view key) const;
  /// The same model with other values of its parameters. Throws LawBroken where they make none; InvalidArgument where a key names no parameter.
  virtual std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const;

  /// The system of second order that the model is; null where it is none.
  virtual const System* second_order() const { return nullptr; }
  /// Its matrices by the names that files of them have: M, G, K; I, G. Empty where it is not made of matrices.
  struct NamedMatrix {
    std::string name, meaning;
    bool skew = false;
    const Matrix* matrix = nullptr;
  };
  virtual std::vector<NamedMatrix> matrices() const { return {}; }
  /// The same model in finite elements.
  virtual std::shared_ptr<const ModelKind> discretised(std::optional<Index> elements) const;
  /// The same model without its couplings up to `tolerance`, and what was left out.
  virtual std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const;
};

/// What a model file declares to be known of it, for whoever wants to check: never used in a computation.
struct KnownValues {
  std::vector<double> frequencies;  ///< rad/s, ascending
  std::string stability;            ///< a word of the verdict, or empty
  std::string system_class;         ///< quadrature, hidden_quadrature, general or transcendental, or empty
};

/// A model, and where it comes from.
struct Model {
  std::string title;
  std::string reference;
  std::string kind;            ///< its word in model files
  std::string sha256;          ///< of the model file followed by its matrix files, in the order M, G, K, per-spin ones (I, G)
  std::shared_ptr<const ModelKind> body;
  std::optional<double> spin;  ///< rad/s, where the model depends on it
  KnownValues known;
  std::optional<IgnoredCouplings> ignored = std::nullopt;  ///< where `body` is that of the file without its weak couplings

  Index size() const { return body->size(); }
  const Labels& labels() const { return body->labels(); }
};

}  // namespace gyromode
