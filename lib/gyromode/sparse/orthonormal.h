#pragma once

#include "gyromode/base/types.h"

namespace gyromode::sparse {

/// For columns x with the Gram matrix xᵀMx in some inner product: C with xC orthonormal, of those directions whose
/// square is above `least`.
Matrix orthonormal_combinations(const Matrix& gram, double least);

}  // namespace gyromode::sparse
