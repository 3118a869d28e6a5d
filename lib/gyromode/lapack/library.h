#pragma once

#include <string>

namespace gyromode::lapack {

/// The BLAS and LAPACK that are linked, for provenance: "OpenBLAS 0.3.21 …".
std::string library();

}  // namespace gyromode::lapack
