#pragma once

#include "gyromode/lapack/types.h"

namespace gyromode::lapack {

/// A = U diag(values) Vᵀ, values descending; A m × n, U m × min(m,n), V n × min(m,n).
struct SingularValues {
  Vector values;
  Matrix u;
  Matrix v;
};

/// Thin singular value decomposition by divide and conquer (dgesdd).
SingularValues singular_value_decomposition(Matrix a);

/// The same for a square upper bidiagonal matrix given by its diagonal (n) and superdiagonal (n − 1) (dbdsdc).
SingularValues bidiagonal_svd(Vector diagonal, Vector superdiagonal);

}  // namespace gyromode::lapack
