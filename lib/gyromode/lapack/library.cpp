#include "gyromode/lapack/library.h"

#include <cblas.h>

namespace gyromode::lapack {

std::string library() { return openblas_get_config(); }

}  // namespace gyromode::lapack
