#pragma once

#include "gyromode/sparse/matrix.h"

#include <vector>

namespace gyromode::sparse {

/// An order of elimination with little fill, by nested dissection of the graph of nodes (METIS): coordinates of one
/// node stay together. `node` of every coordinate, from 0; `pattern` by its lower triangle. result[k] is the position
/// of coordinate k. Does not depend on anything but its arguments.
std::vector<int> node_order(const SparseMatrix& pattern, const std::vector<int>& node);
/// Every coordinate a node of its own.
std::vector<int> node_order(const SparseMatrix& pattern);

}  // namespace gyromode::sparse
