#pragma once

#include "gyromode/sparse/sparse_system.h"
#include "gyromode/structure/structure.h"

namespace gyromode::sparse {

/// Components and partition of the couplings of a sparse system, by walking what is stored; zeros that are stored
/// couple nothing.
Structure analyse(const SparseMatrices& matrices);
inline Structure analyse(const SparseSystem& system) { return analyse(system.matrices()); }

}  // namespace gyromode::sparse
