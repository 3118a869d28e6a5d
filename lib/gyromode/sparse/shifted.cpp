#include "gyromode/sparse/shifted.h"

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

ShiftedImpedance::ShiftedImpedance(const SparseSystem& s, const Structure& structure)
    : system_(s), quadrature_(structure.system_class() == SystemClass::quadrature), across_(static_cast<std::size_t>(s.size()), false) {
  const Index n = s.size(), order = quadrature_ ? n : 2 * n;
  if (quadrature_) {
    for (const Index i : structure.in_quadrature()) across_[static_cast<std::size_t>(i)] = true;
  }
  Triplets entries;
  for (const Index offset : {Index{0}, n}) {
    if (offset > 0 && quadrature_) break;
    add_pattern(s.stiffness(), offset, offset, entries);
    add_pattern(s.mass(), offset, offset, entries);
  }
  const auto each_g = [&](const auto& see) {  // where the entries of G go, with their signs
    for (Index j = 0; j < n; ++j) {
      for (SparseMatrix::InnerIterator it(s.gyroscopic(), j); it; ++it) {
        if (it.value() == 0) continue;
        const Index i = it.row();
        if (!quadrature_) {  // jωG: the block below is ωG, all of it
          see(n + i, j, it.value());
          see(n + j, i, -it.value());
        } else {
          see(i, j, across_[static_cast<std::size_t>(i)] ? -it.value() : it.value());
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
  for (const Index offset : {Index{0}, n}) {
    if (offset > 0 && quadrature_) break;
    for (const auto& [a, values] : {std::pair(&s.stiffness(), &k_), {&s.mass(), &m_}}) {
      for (Index j = 0; j < n; ++j) {
        for (SparseMatrix::InnerIterator it(*a, j); it; ++it) (*values)[place_in(pattern_, it.row() + offset, j + offset)] += it.value();
      }
    }
  }
  each_g([&](Index i, Index j, double value) { g_[place_in(pattern_, i, j)] += value; });
  std::vector<int> node = s.node();
  if (!quadrature_) node.insert(node.end(), s.node().begin(), s.node().end());
  order_ = node_order(pattern_, node);
}

SparseMatrix ShiftedImpedance::at(double omega) const {
  SparseMatrix h = pattern_;
  double* values = h.valuePtr();
  for (std::size_t e = 0; e < k_.size(); ++e) values[e] = k_[e] - omega * omega * m_[e] + omega * g_[e];
  return h;
}

Index ShiftedImpedance::negative_at(double omega) const {
  if (!counter_) counter_ = std::make_unique<SymmetricFactor>(pattern_, order_, SymmetricFactor::Keep::counts);
  const Index negative = counter_->factor(at(omega));
  return quadrature_ ? negative : negative / 2;
}

Index ShiftedImpedance::negative_of_stiffness() const { return negative_at(0); }

Index ShiftedImpedance::factor(double sigma) {
  if (!solver_) solver_ = std::make_unique<SymmetricFactor>(pattern_, order_, SymmetricFactor::Keep::factors);
  if (negative_ && sigma_ == sigma) return *negative_;
  sigma_ = sigma;
  const Index negative = solver_->factor(at(sigma));
  negative_ = quadrature_ ? negative : negative / 2;
  return *negative_;
}

double ShiftedImpedance::megabytes() const { return solver_ ? solver_->megabytes() : 0; }

// H = T H* T⁻¹, T⁻¹ = diag(1, j); or the real and the imaginary part, one below the other.
ComplexMatrix ShiftedImpedance::solve(const ComplexMatrix& r) {
  const Index n = r.rows(), m = r.cols();
  const Complex j(0, 1);
  if (!quadrature_) {
    Matrix both(2 * n, m);
    both << r.real(), r.imag();
    both = solver_->solve(std::move(both));
    return both.topRows(n) + j * both.bottomRows(n);
  }
  ComplexMatrix turned = r;
  for (Index i = 0; i < n; ++i) {
    if (across_[static_cast<std::size_t>(i)]) turned.row(i) *= j;
  }
  const bool real = turned.imag().cwiseAbs().maxCoeff() == 0, imaginary = turned.real().cwiseAbs().maxCoeff() == 0;
  ComplexMatrix x(n, m);
  if (real || imaginary) {
    const Matrix part = solver_->solve(real ? Matrix(turned.real()) : Matrix(turned.imag()));
    x = real ? ComplexMatrix(part.cast<Complex>()) : ComplexMatrix(j * part);
  } else {
    Matrix both(n, 2 * m);
    both << turned.real(), turned.imag();
    both = solver_->solve(std::move(both));
    x = both.leftCols(m) + j * both.rightCols(m);
  }
  for (Index i = 0; i < n; ++i) {
    if (across_[static_cast<std::size_t>(i)]) x.row(i) *= -j;
  }
  return x;
}

}  // namespace gyromode::sparse
