#pragma once

#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/response.h"
#include "gyromode/spacecraft/boom_facts.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/structure/realify.h"
#include "gyromode/stability/stability_map.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gyromode {

/// H at a frequency, made real symmetric.
struct RealifiedAt {
  double omega = 0;
  Realified realified;
};

/// Of a component in which a reversing symmetry was looked for: what was found, or how far the nearest is from being one.
struct SymmetryFinding {
  std::vector<Index> coordinates;
  double departure = 0, threshold = 0, amplification = 0;  ///< SymmetrySearch
  std::optional<Matrix> reflection;                     ///< R, on these coordinates, where one was found
};

/// A fact of a model that its maker may want to check: a number, a matrix, or named numbers.
struct ModelCheck {
  std::string name;
  std::variant<double, Matrix, std::vector<std::pair<std::string, double>>> value;
};

/// What `structure` reports.
struct StructureReport {
  Structure structure;
  InertiaOfK stiffness;
  bool stiffness_applies = true;              ///< false for first-order models
  std::vector<SymmetryFinding> symmetries;
  std::vector<ModelCheck> checks;
  std::optional<RealifiedAt> at;
  std::vector<ClampedBoom> clamped_booms;           ///< of a spacecraft: the poles of its booms
  std::vector<EffectiveAxes> effective_axes;  ///< of spacecraft that axes 1 and 2 do not part into in phase and in quadrature
};

/// What `stability` reports: the verdict with what it rests on.
struct StabilityReport {
  ModesResult result;
  /// The roots of opposite energy sign nearest to each other, rad/s; nothing where there are none.
  std::optional<std::array<double, 2>> opposite;
  /// The eigenvalue of (K, M) nearest to zero that is none, rad²/s²: how far K is from changing its index. Matrix models of second order.
  std::optional<double> stiffness;
  std::vector<std::string> varied;  ///< keys
  std::optional<StabilityMap> map;
};

/// A motion over time, as `response` reports it.
struct ResponseReport {
  Labels labels;             ///< of the rows of the history
  History history;
  bool rates = false;        ///< velocities are to be written as well
  std::vector<ModalShare> modal;
  Stability stability = Stability::unknown;
  double initial_energy = 0, zero_energy = 0, remainder_energy = 0;
  double departure = 0;      ///< of the decomposition, relative
  double phase_error = 0;    ///< rad, at the last time
  bool balance_closed = false;
  std::string remark;
};

/// H(ω)⁻¹f over a grid of frequencies.
struct FrequencyReport {
  Labels labels;
  FrequencyResponse response;
};

}  // namespace gyromode
