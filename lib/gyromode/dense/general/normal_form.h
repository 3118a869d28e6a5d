#pragma once

#include "gyromode/base/types.h"

namespace gyromode::dense {

/// A gyroscopic system in mass-normalised coordinates z: z̈ + Γ ż + k z = 0, Γ skew, k symmetric, n × n. With a
/// partition the first `split` coordinates are in phase and the rest in quadrature: Γ = [0 b; −bᵀ 0], k = diag(k₁, k₂).
struct NormalForm {
  Matrix gamma;
  Matrix k;
  Index split = -1;  ///< −1: no partition

  Index size() const { return k.rows(); }
  bool quadrature() const { return split >= 0; }
};

}  // namespace gyromode::dense
