#include "gyromode/sparse/shifted.h"

#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/node_order.h"

#include <algorithm>

namespace gyromode::sparse {

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

// Adds the entries of a lower triangle at an offset of rows and columns.
void add_pattern(const SparseMatrix& lower, Index rows, Index columns, Triplets& to) {
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it)
      to.emplace_back(static_cast<int>(it.row() + rows), static_cast<int>(j + columns), 0.0);
  }
}

// The place of entry (i, j) among the values of a.
std::size_t place_in(const SparseMatrix& a, Index i, Index j) {
  const auto* first = a.innerIndexPtr() + a.outerIndexPtr()[j];
  const auto* last = a.innerIndexPtr() + a.outerIndexPtr()[j + 1];
  return static_cast<std::size_t>(std::lower_bound(first, last, static_cast<int>(i)) - a.innerIndexPtr());
}

}  // namespace

ShiftedImpedance::ShiftedImpedance(const SparseSystem& system, const Groups& groups) : system_(system), groups_(groups) {}

void ShiftedImpedance::build() const {
  const SparseSystem& s = system_;
  const bool partition = groups_.partition;
  const Index n = s.size(), order = partition ? n : 2 * n;
  Triplets entries, mass;
  for (const Index offset : {Index{0}, n}) {
    if (offset > 0 && partition) break;
    add_pattern(s.stiffness(), offset, offset, entries);
    add_pattern(s.mass(), offset, offset, entries);
  }
  const auto each_g = [&](const auto& see) {  // where the entries of G go, with their signs
    for (Index j = 0; j < n; ++j) {
      for (SparseMatrix::InnerIterator it(s.gyroscopic(), j); it; ++it) {
        if (it.value() == 0) continue;
        const Index i = it.row();
        if (!partition) {  // jωG: the block below is ωG, all of it
          see(n + i, j, it.value());
          see(n + j, i, -it.value());
        } else {
          see(i, j, groups_.across[static_cast<std::size_t>(i)] ? -it.value() : it.value());
        }
      }
    }
  };
  each_g([&](Index i, Index j, double) { entries.emplace_back(static_cast<int>(i), static_cast<int>(j), 0.0); });
  pattern_.resize(order, order);
  pattern_.setFromTriplets(entries.begin(), entries.end());
  Triplets().swap(entries);
  k_.assign(static_cast<std::size_t>(pattern_.nonZeros()), 0);
  m_ = g_ = k_;
  metric_ = pattern_;
  for (const Index offset : {Index{0}, n}) {
    if (offset > 0 && partition) break;
    for (const auto& [a, values] : {std::pair(&s.stiffness(), &k_), {&s.mass(), &m_}}) {
      for (Index j = 0; j < n; ++j) {
        for (SparseMatrix::InnerIterator it(*a, j); it; ++it) (*values)[place_in(pattern_, it.row() + offset, j + offset)] += it.value();
      }
    }
  }
  std::copy(m_.begin(), m_.end(), metric_.valuePtr());
  metric_.prune(0.0);
  each_g([&](Index i, Index j, double value) { g_[place_in(pattern_, i, j)] += value; });
  std::vector<int> node = s.node();
  if (!partition) node.insert(node.end(), s.node().begin(), s.node().end());
  order_ = coordinate_order(s.places(), node);
}

SparseMatrix ShiftedImpedance::values_at(double omega) const {
  SparseMatrix h = pattern_;
  double* values = h.valuePtr();
  for (std::size_t e = 0; e < k_.size(); ++e) values[e] = k_[e] - omega * omega * m_[e] + omega * g_[e];
  return h;
}

std::unique_ptr<const SymmetricFactor> ShiftedImpedance::analysed() const {
  if (order_.empty()) build();
  return std::make_unique<const SymmetricFactor>(pattern_, order_, SymmetricFactor::Keep::factors);
}

// A factorisation that nobody holds any more is written over: its analysis is that of the pattern.
std::shared_ptr<const ShiftedFactor> ShiftedImpedance::at(double sigma) const {
  if (order_.empty()) build();
  for (const auto& f : kept_) {
    if (f->shift == sigma) return f;
  }
  constexpr std::size_t most = 2;
  auto made = std::make_shared<ShiftedFactor>();
  if (kept_.size() == most) {
    const auto oldest = std::move(kept_.front());
    kept_.erase(kept_.begin());
    if (oldest.use_count() == 1) made->factor_ = oldest->factor_;
  }
  if (!made->factor_) made->factor_ = std::make_shared<SymmetricFactor>(pattern_, order_, SymmetricFactor::Keep::factors);
  SymmetricFactor& factor = *made->factor_;
  made->groups_ = &groups_;
  made->shift = sigma;
  const SparseMatrix h = values_at(sigma);
  const Index negative = factor.factor(h);
  made->negative = groups_.partition ? negative : negative / 2;
  made->margin = factor.singular() ? 0 : least_form([&](Matrix x) { return factor.solve(std::move(x)); }, h, metric_);
  kept_.push_back(made);
  return made;
}

Matrix ShiftedFactor::solve_star(const Matrix& r) const { return factor_->solve(r); }

// H = T H* T⁻¹, T⁻¹ = diag(1, j); or the real and the imaginary part, one below the other.
ComplexMatrix ShiftedFactor::solve(const ComplexMatrix& r) const {
  const Index n = r.rows(), m = r.cols();
  const Complex j(0, 1);
  if (!groups_->partition) {
    Matrix both(2 * n, m);
    both << r.real(), r.imag();
    both = factor_->solve(std::move(both));
    return both.topRows(n) + j * both.bottomRows(n);
  }
  ComplexMatrix turned = r;
  for (const Index i : groups_->rows[1]) turned.row(i) *= j;
  const bool real = turned.imag().cwiseAbs().maxCoeff() == 0, imaginary = turned.real().cwiseAbs().maxCoeff() == 0;
  ComplexMatrix x(n, m);
  if (real || imaginary) {
    const Matrix part = solve_star(real ? Matrix(turned.real()) : Matrix(turned.imag()));
    x = real ? ComplexMatrix(part.cast<Complex>()) : ComplexMatrix(j * part);
  } else {
    Matrix both(n, 2 * m);
    both << turned.real(), turned.imag();
    both = solve_star(both);
    x = both.leftCols(m) + j * both.rightCols(m);
  }
  for (const Index i : groups_->rows[1]) x.row(i) *= -j;
  return x;
}

}  // namespace gyromode::sparse
