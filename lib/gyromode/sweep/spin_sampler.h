#pragma once

#include "gyromode/sweep/family_blocks.h"
#include "gyromode/sweep/reduced_family.h"
#include "gyromode/sweep/spin_sample.h"

#include <limits>
#include <optional>
#include <vector>

namespace gyromode {

/// Which modes of every spin are wanted.
struct SampledModes {
  double below = std::numeric_limits<double>::infinity();  ///< b, rad per unit of time
  std::optional<Index> lowest;                             ///< only so many
};

/// Modes of a model at any spin, each with its block, slope and whirl. Safe to be asked from several threads.
class SpinSampler {
 public:
  /// For spins from `first` to `last`.
  SpinSampler(SpinSource source, SampledModes wanted, double first, double last);

  /// Throws LawBroken where there is no model at the spin.
  SpinSample at(double spin) const;

 private:
  SpinSample sample_of(double spin, const ModesResult& result) const;
  void reduce(double first, double last);

  SampledMode sampled(double spin, double omega, const Mode& mode, const ComplexVector& shape) const;
  void separate(double spin, const std::vector<const Mode*>& cluster, SpinSample& to) const;
  ComplexMatrix impedance_slope(double omega, double spin) const;
  Index block_by_coordinates(const Structure& structure, const Mode& mode) const;

  SpinSource source_;
  SampledModes wanted_;
  std::optional<FamilyBlocks> blocks_;
  std::optional<ReducedFamily> reduced_;  // of large families
};

}  // namespace gyromode
