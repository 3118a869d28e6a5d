#pragma once

#include "gyromode/base/types.h"

#include <Eigen/SparseCore>

namespace gyromode {

/// Compressed columns; row numbers of 32 bits.
using SparseMatrix = Eigen::SparseMatrix<double>;

}  // namespace gyromode
