#pragma once

#include "gyromode/sweep/whirl.h"
#include "gyromode/system/spin_family.h"

#include <optional>
#include <vector>

namespace gyromode {

/// The turn J of vectors across an axis by a right angle: x becomes y, y becomes −x. J² = −1.
class QuarterTurn {
 public:
  /// `pairs`: components x and y of vectors.
  explicit QuarterTurn(std::vector<OrbitCoordinates> pairs) : pairs_(std::move(pairs)) {}

  /// Whether J is defined on all coordinates and commutes with M, G₀, G₁, K₀ and K₂, entry by entry.
  bool is_symmetry_of(const SpinFamily& family) const;
  /// 1: JX = jX, as of forward whirl e^{jωt}, −1: JX = −jX, to a relative `tolerance`; nothing else.
  std::optional<int> sense_of(const ComplexVector& x, double tolerance) const;

 private:
  std::vector<OrbitCoordinates> pairs_;
};

}  // namespace gyromode
