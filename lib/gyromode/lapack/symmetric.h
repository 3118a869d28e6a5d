#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// A = V diag(values) Vᵀ, values ascending, V orthogonal (n × n).
struct SymmetricEigen {
  Vector values;
  Matrix vectors;
};

/// All eigenvalues and vectors of a symmetric matrix (n × n, lower triangle read) by divide and conquer (Tridiagonal).
SymmetricEigen symmetric_eigen(Matrix a);

/// ‖A‖_F of a symmetric matrix, lower triangle read (dlansy).
double symmetric_norm(const MatrixView& a);

/// All eigenvalues only, ascending.
Vector symmetric_eigenvalues(Matrix a);

/// A V = B V diag(values), VᵀBV = 1, B positive definite (dsygvd). Throws NotConverged where B is not.
SymmetricEigen symmetric_definite_eigen(Matrix a, Matrix b);

}  // namespace gyromode::lapack
