#pragma once

#include "gyromode/base/sparse_matrix.h"

#include <filesystem>
#include <optional>

namespace gyromode::io {

/// A symmetric (sign 1) or skew (−1) matrix from a file of lines `row column value`, from 1: one triangle of it, as
/// CalculiX stores it (*FREQUENCY, SOLVER=MATRIXSTORAGE: the upper one by columns), both where they agree to 10⁻⁹, or a
/// Matrix Market file of coordinates. Read in pieces: beside the matrix little is held. @returns the lower triangle, of
/// order `order`; 0: of the largest number that occurs.
/// @throws Unreadable with file, line, and what was expected
SparseMatrix read_triplets(const std::filesystem::path& file, Index order, int sign);

/// The order of a Matrix Market file of coordinates that sparse methods serve and dense ones do not: above 5000, with
/// less than one entry in twenty given. Nothing of other files.
std::optional<Index> order_of_large(const std::filesystem::path& file);

}  // namespace gyromode::io
