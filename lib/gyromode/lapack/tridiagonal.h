#pragma once

#include "gyromode/lapack/reflectors.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// A = Q T Qᵀ for symmetric A (n × n, lower triangle read), T tridiagonal (dsytrd). The stages of dsyevd by themselves:
/// what T can tell may make the vectors unnecessary, and the reflectors are applied in wider panels than dormtr's,
/// which takes a fifth off the whole at n = 1000.
class Tridiagonal {
 public:
  /// Throws NotConverged where A is not finite.
  explicit Tridiagonal(Matrix a);

  Index size() const { return diagonal_.size(); }
  /// How many eigenvalues of T are below `bound` (a Sturm count, backward stable: those of A to n ε ‖A‖).
  Index below(double bound) const;
  /// All eigenvalues and vectors of A, by divide and conquer (dstedc).
  SymmetricEigen eigen() const;

 private:
  double unit_ = 1;  ///< A/unit_ was reduced
  Reflectors q_;
  Vector diagonal_, subdiagonal_;
};

}  // namespace gyromode::lapack
