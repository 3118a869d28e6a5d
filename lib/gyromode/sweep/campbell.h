#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/sweep/meetings.h"
#include "gyromode/sweep/spin_sample.h"

#include <limits>
#include <optional>
#include <vector>

namespace gyromode {

/// What is asked.
struct CampbellOptions {
  std::vector<double> spins;                               ///< rad per unit of time, ascending, at least two
  double below = std::numeric_limits<double>::infinity();  ///< modes below this frequency at every spin, rad per unit of time
  std::optional<Index> lowest;                             ///< or the lowest so many at every spin
  std::vector<double> orders{1};                           ///< of excitations, multiples of the spin in the axes of the model
  Progress progress;                                       ///< told "spins", "encounters", "excitations"
};

/// A mode followed over the spins: entries as the spins, nothing where it is not among those asked for.
struct CampbellBranch {
  std::vector<std::optional<SampledMode>> modes;  ///< without shapes
};

/// @throws InvalidArgument for fewer than two spins, or spins and bounds that are none
void require(const CampbellOptions& options);

/// What a diagram of frequencies over the spin shows.
struct Campbell {
  std::vector<double> spins;              ///< looked at, ascending
  std::vector<CampbellBranch> branches;   ///< by their lowest spin, and frequency there
  std::vector<Encounter> encounters;      ///< ascending in the spin
  std::vector<Intersections> excitation;  ///< of every order asked for
  std::vector<Coverage> coverage;         ///< of every spin
  std::vector<Stability> stability;       ///< of every spin
  std::vector<double> growth_rate;        ///< of the fastest growing motion at every spin, 0 without
  bool interrupted = false;               ///< higher spins were not looked at

  /// Whether the modes of every spin are complete, and the intersections where they can be counted.
  bool is_complete() const;
};

/// Frequencies over the spin with the branches they belong to, where these meet, and where excitations do.
/// @throws InvalidArgument for fewer than two spins, or no end of what is asked for; LawBroken where there is no model
/// at a spin
Campbell campbell(const SpinSource& source, const CampbellOptions& options);

}  // namespace gyromode
