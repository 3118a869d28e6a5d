#pragma once

#include "gyromode/lapack/small.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/base/types.h"

#include <cmath>
#include <vector>

namespace gyromode::dense {

/// An orthonormal basis of the columns of y (n × c, c ≤ n, full rank), real or complex.
inline Matrix orthonormal_basis(const Matrix& y) { return lapack::orthonormal_columns(y); }
inline ComplexMatrix orthonormal_basis(const ComplexMatrix& y) { return small::orthonormal_columns(y); }

/// A real orthonormal basis, |group| columns, of the span of the eigenvectors of a real matrix at the positions
/// `group`, which holds the conjugate of every complex one: of a pair the vector with Im > 0 gives its real part, the
/// other its imaginary part.
inline Matrix real_basis(const ComplexMatrix& vectors, const ComplexVector& values, const std::vector<Index>& group) {
  Matrix span(vectors.rows(), static_cast<Index>(group.size()));
  for (std::size_t k = 0; k < group.size(); ++k) {
    const Index i = group[k];
    span.col(static_cast<Index>(k)) = values(i).imag() < 0 ? Vector(vectors.col(i).imag()) : Vector(vectors.col(i).real());
  }
  return orthonormal_basis(span);
}

/// Coefficients y of a real basis, real up to a phase, made real; those of a complex basis as they are. The second
/// argument says which.
inline Vector coefficients(const ComplexVector& y, const Matrix&) {
  Index largest = 0;
  y.cwiseAbs().maxCoeff(&largest);
  return (y * std::conj(y(largest)) / std::abs(y(largest))).real();
}
inline ComplexVector coefficients(const ComplexVector& y, const ComplexMatrix&) { return y; }

}  // namespace gyromode::dense
