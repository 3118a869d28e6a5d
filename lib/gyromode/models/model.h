#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/models/parameters.h"
#include "gyromode/models/reports.h"
#include "gyromode/models/requests.h"
#include "gyromode/models/sensitivities.h"
#include "gyromode/modes/modes.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/sweep/campbell.h"
#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/spin_family.h"
#include "gyromode/system/system.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

class ModelKind;

/// What a model file declares to be known of it, for whoever wants to check: never used in a computation.
struct KnownValues {
  std::vector<double> frequencies;  ///< rad/s, ascending
  std::string stability;            ///< a word of the verdict, or empty
  std::string system_class;         ///< quadrature, hidden_quadrature, general or transcendental, or empty
};

/// The axes that displacements and shapes are in. Frequencies and everything said of a model hold in its own axes:
/// a motion of frequency ω in axes that turn at Ω is one of ω ± Ω in fixed ones.
enum class Frame { unknown, turning, fixed };
std::string_view to_string(Frame frame);

/// A model of whatever kind, from a file or built in code, and what the program answers of it. Copies share what they
/// are made of, which never changes.
///
/// Frequencies are in rad per unit of time of the model (rad/s in SI). Questions that a kind has no answer to throw
/// NotApplicable, with what to use instead.
struct Model {
  Model(System system);            ///< M, G, K
  Model(FirstOrderSystem system);  ///< I, G
  /// At one spin, rad per unit of time. Coordinates whose rows of M are zero are condensed.
  Model(SpinFamily family, double spin);
  Model(Spacecraft spacecraft);  ///< with exact booms
  /// Of a kind of one's own.
  explicit Model(std::shared_ptr<const ModelKind> kind_of_model, std::string word = "");

  std::string title;      ///< for people
  std::string reference;  ///< where it comes from
  std::string kind;       ///< its word in model files
  /// of the model file followed by its matrix files, in the order M, G, K, per-spin ones (I, G); empty of a model built
  /// in code
  std::string sha256;
  std::vector<std::filesystem::path> files;  ///< those that it was read from
  std::shared_ptr<const ModelKind> body;     ///< what answers
  std::optional<double> spin;                ///< rad/s, where the model depends on it
  Frame frame = Frame::unknown;              ///< as its maker says; spacecraft: turning
  KnownValues known;                         ///< for whoever wants to check
  std::optional<IgnoredCouplings> ignored;   ///< where `body` is that of the file without its weak couplings

  Index size() const;            ///< n, the number of coordinates
  const Labels& labels() const;  ///< of the coordinates, n

  /// All modes of a window, or the lowest so many, with verdict and certificate. @throws see find_modes()
  ModesResult modes(const ModesOptions& options = {}) const;
  /// How many modes a window holds. @throws see count_modes()
  CountResult count(const Window& window) const;
  /// The verdict with what it rests on.
  StabilityReport stability(const Progress& progress = {}) const;
  /// The verdict over a grid of one or two parameters, with critical values. @throws InvalidArgument where a key names
  /// no parameter
  StabilityMap stability_over(const std::vector<ParameterAxis>& axes, const Progress& progress = {}) const;
  /// Speeds at which a mode has a multiple of the speed as its frequency, by one pencil: in fixed axes, also of a model
  /// that says its axes turn, where that is ω = |m − 1|Ω of what goes round with them, and (m + 1)Ω against; else in
  /// the axes of the model.
  /// @throws NotApplicable for models that do not say how they depend on the speed
  CriticalSpeeds critical_speeds(const CriticalOptions& options = {}) const;
  /// The same over values of a parameter, a bearing's stiffness say: the critical-speed map. `progress` is told
  /// "values".
  /// @throws InvalidArgument where a key names no parameter
  CriticalMap critical_speeds_over(const ParameterAxis& axis, const CriticalOptions& options = {}, const Progress& progress = {}) const;
  /// ∂ω/∂p of modes with shapes, by the keys of parameters, all that are listed where there are none. @throws
  /// InvalidArgument for a key that names none
  std::vector<Sensitivity> sensitivities(const std::vector<Mode>& modes, const std::vector<std::string>& keys = {}) const;
  /// ∂Ω/∂p of critical speeds. @throws likewise
  std::vector<Sensitivity> sensitivities(const CriticalSpeeds& found, const std::vector<std::string>& keys = {}) const;
  /// Frequencies over the spin, followed as branches, with their encounters and the intersections with excitations.
  /// @throws NotApplicable for models that do not say how they depend on the spin
  Campbell campbell(const CampbellOptions& options) const;
  /// What class it is in and why; with `at` (rad per unit of time, above 0 for a spacecraft) H there, the
  /// transformation and H*.
  StructureReport structure(std::optional<double> at = std::nullopt) const;
  /// Motion over time. @throws InvalidArgument for sizes that do not fit; NotApplicable for models of first order
  ResponseReport response(const MotionRequest& request) const;
  /// The response to f e^{jωt} over a grid of ω. @throws NotApplicable but for matrix models of second order
  FrequencyReport frequency_response(const FrequencyRequest& request) const;

  /// The response to masses out of balance over speeds: Ω²f e^{jΩt}, in turning axes a force at rest. @throws
  /// NotApplicable for models without orbits, or whose axes are not said to be fixed or turning; InvalidArgument where
  /// a place is not known
  UnbalanceReport unbalance_response(const UnbalanceRequest& request) const;

  /// What looks like a mistake though it is lawful, for people, a sentence each: softening without Coriolis forces,
  /// millimetres with kilograms; with modes found, in what unit the `known` frequencies may be.
  std::vector<std::string> doubts() const;
  std::vector<std::string> doubts(const ModesResult& found) const;  ///< those that a result adds
  /// The numbers it is made of.
  std::vector<Parameter> parameters() const;
  /// The same model with other values of some. @throws InvalidArgument for a key that names none; LawBroken where the
  /// values make no model
  Model with(const std::vector<ParameterValue>& values) const;
  /// The same model without its couplings up to `tolerance` of the largest entry of their matrix: an approximation.
  /// @throws NotApplicable for a spacecraft
  Model without_couplings(double tolerance) const;
};

}  // namespace gyromode
