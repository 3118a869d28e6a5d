#include "gyromode/sparse/sparse_system.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/mass_law.h"
#include "gyromode/sparse/node_order.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>
#include <string_view>

namespace gyromode {

namespace {

void require_lower(std::string_view name, const SparseMatrix& a, Index n, bool with_diagonal) {
  if (a.rows() != n || a.cols() != n)
    throw LawBroken(fmt::format("{} is {} × {}: {} × {} was expected, as M is", name, a.rows(), a.cols(), n, n));
  for (Index j = 0; j < n; ++j) {
    for (SparseMatrix::InnerIterator it(a, j); it; ++it) {
      if (!std::isfinite(it.value())) throw LawBroken(fmt::format("{} must be finite: entry ({},{}) is not", name, it.row() + 1, j + 1));
      if (it.row() < j || (it.row() == j && !with_diagonal && it.value() != 0))
        throw LawBroken(
            fmt::format("{}: entry ({},{}) is not {} the diagonal", name, it.row() + 1, j + 1, with_diagonal ? "on or below" : "below"));
    }
  }
}

}  // namespace

SparseSystem::SparseSystem(SparseMatrices matrices) : of_(std::move(matrices)) {
  const Index n = of_.mass.cols();
  for (SparseMatrix* a : {&of_.mass, &of_.gyroscopic, &of_.stiffness}) a->makeCompressed();
  require_lower("M", of_.mass, n, true);
  require_lower("G", of_.gyroscopic, n, false);
  require_lower("K", of_.stiffness, n, true);
  for (const Matrix* free : {&of_.translations, &of_.rigid}) {
    if (free->cols() > 0 && free->rows() != n)
      throw LawBroken(fmt::format("free motions of {} rows where {} coordinates are", free->rows(), n));
  }
  if (of_.labels.empty()) of_.labels = default_labels(n);
  if (static_cast<Index>(of_.labels.size()) != n) throw LawBroken(fmt::format("{} labels where {} coordinates are", of_.labels.size(), n));
  if (of_.node.empty()) {
    of_.node.resize(static_cast<std::size_t>(n));
    std::iota(of_.node.begin(), of_.node.end(), 0);
  }
  places_ = sparse::node_places({&of_.mass, &of_.gyroscopic, &of_.stiffness}, of_.node);
  singular_mass_ = n > 0 && sparse::is_singular_mass(of_.mass, places_, of_.node, of_.labels);
}

double SparseSystem::gyroscopic_size() const {
  const Vector root = of_.mass.diagonal().cwiseSqrt().cwiseInverse();
  return sparse::norm1(SparseMatrix(root.asDiagonal() * of_.gyroscopic * root.asDiagonal()));
}

}  // namespace gyromode
