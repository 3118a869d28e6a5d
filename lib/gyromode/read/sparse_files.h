#pragma once

#include "gyromode/formats/digest.h"
#include "gyromode/sparse/sparse_system.h"

#include <filesystem>

namespace gyromode::io {

/// Files of M, G and K in the formats of read_triplets(); without one, G and K are 0.
struct SparseFiles {
  std::filesystem::path mass, gyroscopic, stiffness;
};

/// Those of order `order`; 0: that of M. @throws Unreadable; LawBroken
SparseMatrices read_sparse_files(const SparseFiles& files, Index order, Digest& digest);

}  // namespace gyromode::io
