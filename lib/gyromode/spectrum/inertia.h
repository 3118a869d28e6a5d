#pragma once

#include "gyromode/base/rounding.h"

namespace gyromode {

/// Numbers of negative and positive eigenvalues of a Hermitian matrix, by Sylvester's law from a factorisation.
struct Inertia {
  Index negative = 0;
  Index positive = 0;
  /// How far from singular: the least |eigenvalue| over the largest, scaled (dense: after equilibration, the lesser of
  /// that of D in a Bunch–Kaufman factorisation and the reciprocal condition in the 1-norm; of a sum of terms the
  /// largest is not less than 1).
  double margin = 1;

  /// A backward error of 8 n ε could move an eigenvalue through zero: the matrix is singular to rounding, and the count
  /// may be off by the number of tiny pivots.
  bool doubtful() const { return !(margin > zero_to_rounding(negative + positive)); }
};

}  // namespace gyromode
