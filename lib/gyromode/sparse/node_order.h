#pragma once

#include "gyromode/sparse/matrix.h"

#include <vector>

namespace gyromode::sparse {

/// An order of elimination with little fill, by nested dissection of the graph of nodes (METIS): the place of every
/// node. `node` of every coordinate, from 0; `patterns` by their lower triangles. Does not depend on anything but its
/// arguments. @throws TooLarge
std::vector<int> node_places(const std::vector<const SparseMatrix*>& patterns, const std::vector<int>& node);

/// The same for coordinates, those of one node together: result[k] is the position of coordinate k, whose node is
/// node[k].
std::vector<int> coordinate_order(const std::vector<int>& places, const std::vector<int>& node);

}  // namespace gyromode::sparse
