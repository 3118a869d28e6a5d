#include "gyromode/sparse/stiffness.h"

#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/node_order.h"

#include <algorithm>

namespace gyromode::sparse {

StiffnessFactors::~StiffnessFactors() = default;

StiffnessFactors::StiffnessFactors(const SparseSystem& s, const Groups& groups) : system_(s) {
  for (const std::vector<Index>& rows : groups.rows) {
    if (rows.empty()) continue;
    Block b;
    b.rows = rows;
    const SparseMatrix k = restricted(s.stiffness(), rows), m = restricted(s.mass(), rows);
    std::vector<int> node;
    for (const Index i : rows) node.push_back(s.node()[static_cast<std::size_t>(i)]);
    const std::vector<int> order = coordinate_order(s.places(), node);
    const Vector diagonal = k.diagonal();
    const bool perhaps_definite = diagonal.minCoeff() > 0;
    for (const auto kind : {SymmetricFactor::Kind::definite, SymmetricFactor::Kind::indefinite}) {
      if (kind == SymmetricFactor::Kind::definite && !perhaps_definite) continue;
      b.factor = std::make_unique<SymmetricFactor>(k, order, SymmetricFactor::Keep::factors, kind);
      b.negative = b.factor->factor(k);
      if (b.negative == 0 && !b.factor->singular()) break;
    }
    b.margin = b.factor->singular() ? 0 : least_form([&](Matrix x) { return b.factor->solve(std::move(x)); }, k, m);
    blocks_.push_back(std::move(b));
  }
}

bool StiffnessFactors::definite(Index block) const { return negative(block) == 0 && margin(block) > singular_margin; }

Index StiffnessFactors::negative() const {
  Index all = 0;
  for (const Block& b : blocks_) all += b.negative;
  return all;
}

double StiffnessFactors::margin() const {
  double least = 1;
  for (const Block& b : blocks_) least = std::min(least, b.margin);
  return least;
}

Matrix StiffnessFactors::solve(Index block, const Matrix& b) const {
  const Block& of = blocks_[static_cast<std::size_t>(block)];
  Matrix part(static_cast<Index>(of.rows.size()), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < part.rows(); ++i) part(i, j) = b(of.rows[static_cast<std::size_t>(i)], j);
  }
  part = of.factor->solve(std::move(part));
  Matrix x = Matrix::Zero(b.rows(), b.cols());
  for (Index j = 0; j < b.cols(); ++j) {
    for (Index i = 0; i < part.rows(); ++i) x(of.rows[static_cast<std::size_t>(i)], j) = part(i, j);
  }
  return x;
}

}  // namespace gyromode::sparse
