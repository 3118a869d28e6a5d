#pragma once

#include "gyromode/base/sparse_matrix.h"

#include <filesystem>

namespace gyromode::io {

/// A symmetric matrix from a file of lines `row column value`, from 1: one triangle of it, as CalculiX stores it
/// (*FREQUENCY, SOLVER=MATRIXSTORAGE: the upper one by columns), or a symmetric Matrix Market file of coordinates. Read
/// in pieces: beside the matrix little is held. @returns the lower triangle, of order `order`; 0: of the largest number
/// that occurs.
/// @throws Unreadable with file, line, and what was expected
SparseMatrix read_symmetric_triplets(const std::filesystem::path& file, Index order);

}  // namespace gyromode::io
