#include "gyromode/lapack/library.h"

#include <cblas.h>

namespace gyromode::lapack {

std::string library() { return openblas_get_config(); }

int threads() { return openblas_get_num_threads(); }

}  // namespace gyromode::lapack
