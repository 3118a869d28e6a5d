#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// A = V diag(values) Vᴴ, values ascending, V unitary (n × n).
struct HermitianEigen {
  Vector values;
  ComplexMatrix vectors;
};

/// All eigenvalues and vectors of a Hermitian matrix (n × n, lower triangle read) by divide and conquer (zheevd).
HermitianEigen hermitian_eigen(const ComplexMatrix& a);

}  // namespace gyromode::lapack
