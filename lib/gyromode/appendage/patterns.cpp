#include "gyromode/appendage/patterns.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <vector>

namespace gyromode {

namespace {

// Entries of sums of n products up to this fraction of their terms are rounding of the azimuths.
constexpr double rounding = 64 * epsilon;

// Sets of features that are coupled, by their Gram matrix.
std::vector<std::vector<Index>> coupled_sets(const Matrix& gram) {
  std::vector<std::vector<Index>> sets;
  std::vector<bool> seen(static_cast<std::size_t>(gram.rows()), false);
  for (Index start = 0; start < gram.rows(); ++start) {
    if (seen[static_cast<std::size_t>(start)] || gram(start, start) == 0) continue;
    std::vector<Index> set{start};
    seen[static_cast<std::size_t>(start)] = true;
    for (std::size_t k = 0; k < set.size(); ++k) {
      for (Index other = 0; other < gram.rows(); ++other) {
        if (seen[static_cast<std::size_t>(other)] || gram(set[k], other) == 0) continue;
        seen[static_cast<std::size_t>(other)] = true;
        set.push_back(other);
      }
    }
    sets.push_back(set);
  }
  return sets;
}

void drop_rounding(Matrix& a, const Vector& rows, const Vector& columns) {
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index k = 0; k < a.cols(); ++k) {
      if (std::abs(a(i, k)) <= rounding * rows(i) * columns(k)) a(i, k) = 0;
    }
  }
}

}  // namespace

Patterns patterns(const Matrix& features) {
  const Index n = features.rows();
  const Vector size = features.colwise().norm();
  Patterns p;
  p.gram = features.transpose() * features;
  drop_rounding(p.gram, size, size);
  Matrix found(n, 0);
  for (const auto& set : coupled_sets(p.gram)) {
    Matrix part = features(Eigen::all, set);
    part = part * size(set).cwiseInverse().asDiagonal();
    const auto [rank, q] = small::ranked_qr(part, rounding);
    found.conservativeResize(n, found.cols() + rank);
    found.rightCols(rank) = q;
  }
  p.coupled = found.cols();
  p.vectors.resize(n, n);
  p.vectors.leftCols(p.coupled) = found;
  if (p.coupled < n) {
    const Matrix all = p.coupled > 0 ? small::orthogonal_factor(found) : Matrix(Matrix::Identity(n, n));
    p.vectors.rightCols(n - p.coupled) = all.rightCols(n - p.coupled);
  }
  p.response = found.transpose() * features;
  drop_rounding(p.response, Vector::Ones(p.coupled), size);
  return p;
}

}  // namespace gyromode
