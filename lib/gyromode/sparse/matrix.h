#pragma once

#include "gyromode/base/sparse_matrix.h"

#include <vector>

namespace gyromode::sparse {

/// Re z and Im z, side by side. n × 2
Matrix parts_of(const ComplexVector& z);
/// AX of a symmetric A given by its lower triangle, diagonal included.
Matrix symmetric_times(const SparseMatrix& lower, const Matrix& x);
/// AX of a skew A given by what is below its diagonal.
Matrix skew_times(const SparseMatrix& below, const Matrix& x);
/// A symmetric (sign 1) or skew (−1) A by its lower triangle, in full.
Matrix full(const SparseMatrix& lower, double sign);
/// BX and BᵀX of any sparse B.
Matrix times(const SparseMatrix& b, const Matrix& x);
Matrix transposed_times(const SparseMatrix& b, const Matrix& x);
/// |x|ᵀ|A||x| of a (skew-)symmetric A by its lower triangle, of every column of moduli |x|: what rounding of its
/// entries is relative to.
Vector sizes_of(const SparseMatrix& lower, const Matrix& moduli);
/// The largest column sum of |A| of a (skew-)symmetric A given by its lower triangle.
double norm1(const SparseMatrix& lower);
/// The rows and columns `chosen` (ascending) of a symmetric or skew A, of its lower triangle.
SparseMatrix restricted(const SparseMatrix& lower, const std::vector<Index>& chosen);

/// Rows `rows` and columns `columns` of a symmetric A, of its lower triangle.
SparseMatrix block_of(const SparseMatrix& lower, const std::vector<Index>& rows, const std::vector<Index>& columns);

}  // namespace gyromode::sparse
