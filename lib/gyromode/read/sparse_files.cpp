#include "gyromode/read/sparse_files.h"

#include "gyromode/formats/triplet_file.h"

namespace gyromode::io {

SparseMatrices read_sparse_files(const SparseFiles& files, Index order, Digest& digest) {
  const auto read = [&](const std::filesystem::path& file, Index n, int sign) {
    if (file.empty()) return SparseMatrix(n, n);
    digest.add_large(file);
    return read_triplets(file, n, sign);
  };
  SparseMatrices m;
  m.mass = read(files.mass, order, 1);
  const Index n = m.mass.cols();
  m.gyroscopic = read(files.gyroscopic, n, -1);
  m.stiffness = read(files.stiffness, n, 1);
  return m;
}

}  // namespace gyromode::io
