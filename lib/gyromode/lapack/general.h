#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// A V = V diag(values); column k of `vectors` belongs to values(k), 2-norm 1; conjugate pairs stand side by side,
/// the one with positive imaginary part first.
struct GeneralEigen {
  ComplexVector values;
  ComplexMatrix vectors;
};

/// All eigenvalues and right vectors of a real n × n matrix (dgeev: balanced, Hessenberg, QR).
GeneralEigen general_eigen(Matrix a);

/// The same for a complex matrix (zgeev); values in no particular order.
GeneralEigen general_eigen(ComplexMatrix a);

}  // namespace gyromode::lapack
