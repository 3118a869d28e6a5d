#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// A = U diag(values) Vᵀ, values descending; A m × n, U m × min(m,n), Vᵀ min(m,n) × n.
struct SingularValues {
  Vector values;
  Matrix u;
  Matrix vt;
};

/// Thin singular value decomposition by divide and conquer (dgesdd).
SingularValues singular_value_decomposition(Matrix a);

/// The same for a square upper bidiagonal matrix given by its diagonal (n) and superdiagonal (n − 1) (dbdsdc).
SingularValues bidiagonal_svd(Vector diagonal, Vector superdiagonal);

/// U and the values of A = U diag(values) Vᵀ only, A n × n, values descending (dgebrd, dbdsdc): V is not transformed
/// back.
struct LeftSingular {
  Vector values;
  Matrix vectors;
};
LeftSingular left_singular(Matrix a);

}  // namespace gyromode::lapack
