#pragma once

#include <string>

namespace gyromode::lapack {

/// The BLAS and LAPACK that are linked, for provenance: "OpenBLAS 0.3.21 …".
std::string library();

/// How many threads the BLAS uses (OPENBLAS_NUM_THREADS).
int threads();

}  // namespace gyromode::lapack
