#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/models/parameters.h"
#include "gyromode/models/reports.h"
#include "gyromode/models/requests.h"
#include "gyromode/modes/modes.h"
#include "gyromode/spectrum/energy_share.h"
#include "gyromode/sweep/campbell.h"
#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/sweep/spin_sample.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gyromode {

/// A kind of model: what it says of itself, and what it answers. Questions that a kind has no answer to throw
/// NotApplicable, with what to use instead.
class ModelKind {
 public:
  virtual ~ModelKind() = default;

  virtual Index size() const = 0;
  virtual const Labels& labels() const = 0;
  /// For people, after the number of coordinates: "M, G, K".
  virtual std::string_view in_words() const = 0;
  /// Coordinates without mass, which follow the others.
  virtual Labels massless() const { return {}; }
  /// Whether H depends on ω by more than powers: there may be infinitely many modes.
  virtual bool transcendental() const { return false; }
  virtual bool finite() const { return true; }
  /// Whether modes come with lines for pictures.
  virtual bool has_outlines() const { return false; }

  virtual ModesResult modes(const ModesOptions& options) const = 0;
  virtual CountResult count(const Window& window) const = 0;
  /// The factorisations that modes would take, estimated; none of models that are dense.
  virtual std::vector<PlannedFactorisation> plan() const { return {}; }
  /// The modes that a verdict on stability needs, and no more.
  virtual ModesResult verdict(bool with_shapes, const Progress& progress = {}) const;
  virtual StabilityReport stability(const Progress& progress) const;
  /// `at`: also H there, rad per unit of time.
  virtual StructureReport structure(std::optional<double> at) const = 0;
  /// Throws NotApplicable unless it has displacements and velocities that move over time.
  virtual void require_motion() const;
  virtual ResponseReport response(const MotionRequest& request) const;
  virtual FrequencyReport frequency_response(const FrequencyRequest& request) const;

  /// What looks like a mistake though it is lawful, for people; `fixed_axes`: they are said to be.
  virtual std::vector<std::string> doubts(bool fixed_axes [[maybe_unused]]) const { return {}; }

  /// Throws NotApplicable unless it is a family of matrices with a spin.
  virtual CriticalSpeeds critical_speeds(const CriticalOptions& options) const;

  /// Masses out of balance as a force on the coordinates, in axes that do not turn: Re(Ω²f e^{jrΩt}).
  struct TurningForce {
    ComplexVector per_speed2;  ///< f, kg m
    double speed_ratio = 1;    ///< r, of the shaft that they are on
  };
  /// Throws NotApplicable unless it has places with orbits; InvalidArgument where a place is none of them, or shafts of
  /// different speed are named.
  virtual TurningForce unbalance(const std::vector<Unbalance>& masses) const;

  /// Displacements across the axis of its stations, whose orbits say how a mode whirls.
  virtual std::vector<OrbitCoordinates> orbits() const { return {}; }
  /// How the energies of a mode with its shape are shared among the parts: by coordinates of matrices. `outlines` as in
  /// the result that the mode is of. Empty where the shape says nothing.
  virtual std::vector<EnergyShare> energy_shares(const Mode& mode, const std::vector<ModelOutline>& outlines) const;

  /// What the field calls a mode with its shape and shares: "nutation"; empty where it has no name.
  virtual std::string name_of(const Mode& mode, const std::vector<EnergyShare>& shares) const;

  /// What it says of itself to a sweep over its spin. Throws NotApplicable where it does not say how it depends on one.
  virtual SpinSource spin_source() const;

  /// Frequencies over the spin. @throws as spin_source()
  virtual Campbell campbell(const CampbellOptions& options) const { return gyromode::campbell(spin_source(), options); }

  /// ∂H/∂Ω X and −∂H/∂ω X of shapes X, n × m, at ω.
  struct SpinSlopes {
    ComplexMatrix by_spin, form;
  };
  /// Of a large model that says how it depends on its spin; else nothing.
  virtual std::optional<SpinSlopes> spin_slopes(double omega [[maybe_unused]], const ComplexMatrix& shapes [[maybe_unused]]) const {
    return std::nullopt;
  }

  /// The key of its spin.
  virtual std::string speed_key() const { return "spin"; }

  /// Values of the parameter `key` between a and b at which K is singular, so that divergence may begin or end: all of
  /// them where they are known of a kind of model, else none.
  virtual std::vector<double> divergence_thresholds(std::string_view key, double a, double b) const;

  /// The numbers it is made of, those worth listing; further ones may be named.
  virtual std::vector<Parameter> parameters() const { return {}; }
  /// Those of them that have a meaning of their own: no entries of matrices.
  virtual std::vector<Parameter> named_parameters() const { return parameters(); }
  /// The first number that a key names ([*] for every item); nothing where it names none.
  virtual std::optional<Parameter> parameter(std::string_view key) const;
  /// The same model with other values of its parameters. Throws LawBroken where they make none; InvalidArgument where a
  /// key names no parameter.
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
  /// The matrices of the same model with other values of its parameters. Throws as with().
  virtual std::vector<Matrix> matrices_with(const std::vector<ParameterValue>& values) const;
  /// What was left out, of a model without its weak couplings.
  virtual std::optional<IgnoredCouplings> left_out() const { return std::nullopt; }
  /// The same model in finite elements.
  virtual std::shared_ptr<const ModelKind> discretised(std::optional<Index> elements) const;
  /// The same model without its couplings up to `tolerance`, and what was left out.
  virtual std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const;
};

}  // namespace gyromode
