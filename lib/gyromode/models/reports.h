#pragma once

#include "gyromode/motion/frequency_response.h"
#include "gyromode/models/requests.h"
#include "gyromode/motion/response.h"
#include "gyromode/spacecraft/boom_facts.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/structure/realify.h"
#include "gyromode/stability/stability_map.h"
#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/sweep/synchronous_response.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gyromode {

/// H at a frequency, made real symmetric.
struct RealifiedAt {
  double omega = 0;     ///< rad per unit of time
  Realified realified;  ///< H, U and H*
};

/// Of a component in which a reversing symmetry was looked for: what was found, or how far the nearest is from being
/// one.
struct SymmetryFinding {
  std::vector<Index> coordinates;    ///< of the component
  double departure = 0;              ///< of the reflection found, or of the nearest, from being one
  double threshold = 0;              ///< what rounding of the matrices explains
  double amplification = 0;          ///< of that rounding by mass-normalised coordinates
  std::optional<Matrix> reflection;  ///< R, on these coordinates, where one was found
};

/// A fact of a model that its maker may want to check: a number, a matrix, or named numbers.
struct ModelCheck {
  std::string name;                                                                              ///< key in the document
  std::variant<double, Matrix, std::vector<std::pair<std::string, double>>, std::string> value;  ///< SI
};

/// What `structure` reports.
struct StructureReport {
  Structure structure;                        ///< components and partition
  InertiaOfK stiffness;                       ///< of the whole K
  bool stiffness_applies = true;              ///< false for first-order models
  std::vector<SymmetryFinding> symmetries;    ///< of components without a partition
  std::vector<ModelCheck> checks;             ///< facts of the model
  std::optional<RealifiedAt> at;              ///< where a frequency was given
  std::vector<Repair> repairs;                ///< of matrices that were not (skew-)symmetric
  std::vector<ClampedBoom> clamped_booms;     ///< of a spacecraft: the poles of its booms
  std::vector<EffectiveAxes> effective_axes;  ///< of spacecraft that axes 1 and 2 do not part into in phase and in quadrature
};

/// Critical speeds over values of a parameter.
struct CriticalMap {
  /// At one value.
  struct Row {
    double value = 0;       ///< of the parameter, SI
    CriticalSpeeds speeds;  ///< there; none where there is no model
    std::string reason;     ///< why there is no model there; empty where there is one
  };
  std::string keys;          ///< of the parameter
  std::vector<Row> rows;     ///< ascending
  bool interrupted = false;  ///< higher values were not looked at

  /// Whether any of the values makes a model.
  bool has_a_model() const;
  /// Whether the lists of all values are complete.
  bool is_complete() const;
};

/// What `stability` reports: the verdict with what it rests on.
struct StabilityReport {
  ModesResult result;  ///< verdict, balance, modes of negative energy, growing motions
  /// The roots of opposite energy sign nearest to each other, rad/s; nothing where there are none.
  std::optional<std::array<double, 2>> opposite;
  /// The eigenvalue of (K, M) nearest to zero that is none, rad²/s²: how far K is from changing its index. Matrix
  /// models of second order.
  std::optional<double> stiffness;
  std::vector<std::string> varied;  ///< keys
  std::optional<StabilityMap> map;  ///< over parameters, where asked for
};

/// A motion over time, as `response` reports it.
struct ResponseReport {
  Labels labels;                             ///< of the rows of the history
  History history;                           ///< displacements and velocities over time
  bool rates = false;                        ///< velocities are to be written as well
  std::vector<ModalShare> modal;             ///< of each mode in the free motion
  Stability stability = Stability::unknown;  ///< of the model
  double initial_energy = 0;                 ///< at t = 0⁺
  double zero_energy = 0;                    ///< of displaced rest and drift
  double remainder_energy = 0;               ///< of growing motions and double roots
  std::optional<double> energy_left_out;     ///< of a large sparse model: in modes beyond those of the window
  double departure = 0;                      ///< of the decomposition, relative
  double phase_error = 0;                    ///< rad, at the last time
  std::optional<Coverage> coverage;          ///< of a large sparse model: whether the modes of the window are all
  bool balance_closed = false;               ///< whether the roots account for all of the motion
  std::string remark;                        ///< for people; may be empty

  /// Why the motion is not certified, for people; empty where it is: the balance closes, the modes of a window are all,
  /// departure and phase error are up to 10⁻⁶.
  std::vector<std::string> doubts() const;
  /// Keeps those coordinates alone of the first n, unless they are none. What is no coordinate stays.
  void keep_only(const std::vector<Index>& chosen, Index n);
};

/// H(ω)⁻¹f over a grid of frequencies.
struct FrequencyReport {
  Labels labels;               ///< of the entries of q
  FrequencyResponse response;  ///< point by point

  /// What is to be said of points of the grid that are on a mode, and of modes that may be missing, for people.
  std::vector<std::string> remarks() const;
  /// Keeps those coordinates alone, unless they are none.
  void keep_only(const std::vector<Index>& chosen);
};

/// The response to unbalance over speeds.
struct UnbalanceReport {
  std::vector<Unbalance> masses;         ///< as asked
  Labels labels;                         ///< of the entries of q
  std::vector<OrbitCoordinates> places;  ///< whose orbits are of interest
  double speed_ratio = 1;                ///< of what turns, to the speed
  SynchronousResponse response;          ///< point by point

  /// The orbit of a place at a point that is no resonance, in the axes of the model; of a force at rest in turning axes
  /// (order 0), where q is a constant displacement, the circle that it is in fixed ones.
  Orbit orbit(const SynchronousPoint& point, std::size_t place) const;
  /// What is to be said of points of the grid that are on a critical speed, for people.
  std::vector<std::string> remarks() const;
};

}  // namespace gyromode
