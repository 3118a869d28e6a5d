#pragma once

#include "gyromode/sparse/matrix.h"

namespace gyromode::sparse {

/// null(A) of a symmetric A, and the eigenvalues λ of Ax = λMx about it.
struct NullSpace {
  Matrix basis;        ///< N, n × r: NᵀMN = 1
  Index negative = 0;  ///< n₋(A)
  double shift = 0;    ///< ν: the r eigenvalues in (−ν, ν) are zero to rounding
  double next = 0;     ///< the least |λ| that is not zero, about; infinite where there is none
};

/// A and M by lower triangles, M > 0, `order` of elimination. r is a count: n₋(A − νM) − n₋(A + νM), and as many
/// vectors with |xᵀAx| ≤ 10³ε |x|ᵀ|A||x| are shown. @throws NotApplicable where eigenvalues come too near to zero for
/// that, or are too many; TooLarge
NullSpace null_space_of(const SparseMatrix& a, const SparseMatrix& mass, const std::vector<int>& order);

}  // namespace gyromode::sparse
