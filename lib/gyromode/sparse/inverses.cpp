#include "gyromode/sparse/inverses.h"

#include "gyromode/base/rounding.h"
#include "gyromode/sparse/matrix.h"

namespace gyromode::sparse {

namespace {

// With the groups exchanged B becomes −Bᵀ.
SparseMatrix coupling_from(const SparseSystem& s, const Groups& g, Index first) {
  SparseMatrix c = coupling_of(s, g);
  if (first == 1) c *= -1;
  return c;
}

Matrix rows_of(const std::vector<Index>& rows, const Matrix& x) {
  Matrix part = Matrix::Zero(x.rows(), x.cols());
  for (Index j = 0; j < x.cols(); ++j) {
    for (const Index i : rows) part(i, j) = x(i, j);
  }
  return part;
}

// x in the rows of one group, y in the others.
Matrix joined(const std::vector<Index>& rows, const Matrix& x, const Matrix& y) {
  Matrix both = y;
  for (Index j = 0; j < x.cols(); ++j) {
    for (const Index i : rows) both(i, j) = x(i, j);
  }
  return both;
}

// diag(K₁, M₂) in the order of the coordinates, by its lower triangle.
SparseMatrix energy_matrix(const SparseSystem& s, const Groups& g, Index first) {
  const auto leads = [&](Index i) { return g.across[static_cast<std::size_t>(i)] == (first == 1); };
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [a, leading] : {std::pair(&s.stiffness(), true), {&s.mass(), false}}) {
    for (Index j = 0; j < a->outerSize(); ++j) {
      if (leads(j) != leading) continue;
      for (SparseMatrix::InnerIterator it(*a, j); it; ++it)
        entries.emplace_back(static_cast<int>(it.row()), static_cast<int>(j), it.value());
    }
  }
  SparseMatrix e(s.size(), s.size());
  e.setFromTriplets(entries.begin(), entries.end());
  return e;
}

// diag(K, M) (q, q̇).
Matrix energy_of(const SparseSystem& s, const Matrix& u) {
  const Index n = s.size();
  Matrix e(2 * n, u.cols());
  e << symmetric_times(s.stiffness(), u.topRows(n)), symmetric_times(s.mass(), u.bottomRows(n));
  return e;
}

// What M makes of q̇ in (q, q̇).
void settle_velocities(const SparseSystem& s, States& u) {
  const Index n = s.size();
  u.ex.bottomRows(n) = symmetric_times(s.mass(), u.x.bottomRows(n));
}

// Below that part of the energy rounding of products is less than what drifts along.
bool rough_at(const SparseSystem& s, double sigma) {
  constexpr double harmless = 1e-12;
  const double largest = s.stiffness().diagonal().cwiseQuotient(s.mass().diagonal()).cwiseAbs().maxCoeff();
  return epsilon * largest > harmless * sigma * sigma;
}

}  // namespace

InverseOfBlocks::InverseOfBlocks(const SparseSystem& system, const Groups& groups, const StiffnessFactors& stiffness, Index first)
    : system_(system),
      groups_(groups),
      stiffness_(stiffness),
      first_(first),
      leading_(static_cast<Index>(groups.rows[static_cast<std::size_t>(first)].size())) {
  const std::vector<Index>&one = groups.rows[static_cast<std::size_t>(first)], &two = groups.rows[static_cast<std::size_t>(1 - first)];
  k_ = restricted(system.stiffness(), one);
  m_first_ = restricted(system.mass(), one);
  m_second_ = restricted(system.mass(), two);
  coupling_ = block_of(coupling_from(system, groups, first), one, two);
}

States InverseOfBlocks::start(const Matrix& shapes) const {
  const Matrix x = states(shapes);
  States u{x, Matrix(x.rows(), x.cols())};
  settle(u);  // what the first group has of E u is not looked at
  return apply(u);
}

States InverseOfBlocks::apply(const States& u) const {
  const Index n = system_.size(), m = u.x.cols(), rest = n - leading_;
  States w{Matrix(n, m), Matrix(n, m)};
  const Matrix x = u.x.topRows(leading_);
  Matrix g = symmetric_times(m_first_, x);
  if (rest > 0) {
    const Matrix y = stiffness_.solve_block(1 - first_, transposed_times(coupling_, x) - u.ex.bottomRows(rest));
    g += times(coupling_, y);
    w.x.bottomRows(rest) = -y;
    w.ex.bottomRows(rest) = -symmetric_times(m_second_, y);
  }
  w.ex.topRows(leading_) = g;
  w.x.topRows(leading_) = stiffness_.solve_block(stiffness_.blocks() == 1 ? 0 : first_, std::move(g));
  return w;
}

Matrix InverseOfBlocks::inner(const Matrix& x) const {
  Matrix e(x.rows(), x.cols());
  e.topRows(leading_) = symmetric_times(k_, x.topRows(leading_));
  e.bottomRows(x.rows() - leading_) = symmetric_times(m_second_, x.bottomRows(x.rows() - leading_));
  return e;
}

void InverseOfBlocks::settle(States& u) const {
  const Index rest = u.x.rows() - leading_;
  u.ex.bottomRows(rest) = symmetric_times(m_second_, u.x.bottomRows(rest));
}

Matrix InverseOfBlocks::shapes(const Matrix& states) const {
  Matrix x(states.rows(), states.cols());
  const std::vector<Index>&one = groups_.rows[static_cast<std::size_t>(first_)], &two = groups_.rows[static_cast<std::size_t>(1 - first_)];
  for (Index j = 0; j < x.cols(); ++j) {
    for (std::size_t i = 0; i < one.size(); ++i) x(one[i], j) = states(static_cast<Index>(i), j);
    for (std::size_t i = 0; i < two.size(); ++i) x(two[i], j) = states(leading_ + static_cast<Index>(i), j);
  }
  return x;
}

Matrix InverseOfBlocks::states(const Matrix& in_order) const {
  Matrix u(in_order.rows(), in_order.cols());
  const std::vector<Index>&one = groups_.rows[static_cast<std::size_t>(first_)], &two = groups_.rows[static_cast<std::size_t>(1 - first_)];
  for (Index j = 0; j < u.cols(); ++j) {
    for (std::size_t i = 0; i < one.size(); ++i) u(static_cast<Index>(i), j) = in_order(one[i], j);
    for (std::size_t i = 0; i < two.size(); ++i) u(leading_ + static_cast<Index>(i), j) = in_order(two[i], j);
  }
  return u;
}

InverseAtShift::InverseAtShift(const SparseSystem& system, const Groups& groups, std::shared_ptr<const ShiftedFactor> impedance,
                               Index first)
    : system_(system),
      groups_(groups),
      impedance_(std::move(impedance)),
      first_(first),
      coupling_(coupling_from(system, groups, first)),
      energy_(energy_matrix(system, groups, first)) {}

States InverseAtShift::start(const Matrix& shapes) const { return apply({shapes, Matrix()}); }

States InverseAtShift::apply(const States& u) const {
  const double sigma = impedance_->shift;
  const std::vector<Index>& one = groups_.rows[static_cast<std::size_t>(first_)];
  const Matrix m = symmetric_times(system_.mass(), u.x), c = symmetric_times(coupling_, rows_of(one, u.x));
  const Matrix r = joined(one, -m, (c - m) / sigma);
  // H* has B from the first group to the second: where the groups are exchanged, −B, z changes its sign.
  const double sign = first_ == 0 ? 1 : -1;
  Matrix w = joined(one, r, sign * r);
  w = impedance_->solve_star(w);
  w = joined(one, w, (sign * sigma) * w);
  const Matrix mw = symmetric_times(system_.mass(), w), cw = symmetric_times(coupling_, w);
  const Matrix kx = sigma * sigma * mw - m - cw;  // of the first group: K₁x = −M₁f₁ + σ²M₁x − Bẏ
  return {w, joined(one, kx, mw)};
}

Matrix InverseAtShift::inner(const Matrix& x) const { return symmetric_times(energy_, x); }

bool InverseAtShift::rough_products() const { return rough_at(system_, impedance_->shift); }

void InverseAtShift::settle(States& u) const {
  const std::vector<Index>& one = groups_.rows[static_cast<std::size_t>(first_)];
  u.ex = joined(one, u.ex, symmetric_times(system_.mass(), u.x));
}

States InverseOfMotion::start(const Matrix& shapes) const {
  const Matrix m = symmetric_times(system_.mass(), shapes);
  States w{Matrix::Zero(length(), shapes.cols()), Matrix::Zero(length(), shapes.cols())};
  w.x.topRows(shapes.rows()) = stiffness_.solve(0, m);
  w.ex.topRows(shapes.rows()) = m;
  return w;
}

States InverseOfMotion::apply(const States& u) const {
  const Index n = system_.size(), m = u.x.cols();
  const Matrix q = u.x.topRows(n), r = -(u.ex.bottomRows(n) + skew_times(system_.gyroscopic(), q));
  States w{Matrix(2 * n, m), Matrix(2 * n, m)};
  w.x << stiffness_.solve(0, r), q;
  w.ex << r, symmetric_times(system_.mass(), q);
  return w;
}

Matrix InverseOfMotion::inner(const Matrix& x) const { return energy_of(system_, x); }

void InverseOfMotion::settle(States& u) const { settle_velocities(system_, u); }

States InverseOfMotionAtShift::start(const Matrix& shapes) const {
  Matrix x = Matrix::Zero(length(), shapes.cols());
  x.bottomRows(shapes.rows()) = shapes;
  return apply({x, Matrix()});
}

States InverseOfMotionAtShift::apply(const States& u) const {
  const Index n = system_.size();
  const double sigma = impedance_->shift;
  const Matrix f1 = u.x.topRows(n), f2 = u.x.bottomRows(n);
  ComplexMatrix r(n, u.x.cols());
  r.real() = -(symmetric_times(system_.mass(), f2) + skew_times(system_.gyroscopic(), f1));
  r.imag() = -sigma * symmetric_times(system_.mass(), f1);
  r = impedance_->solve(r);
  States w{Matrix(2 * n, u.x.cols()), Matrix(2 * n, u.x.cols())};
  w.x << r.imag() / sigma, r.real();
  w.ex = inner(w.x);
  return w;
}

Matrix InverseOfMotionAtShift::inner(const Matrix& x) const { return energy_of(system_, x); }

bool InverseOfMotionAtShift::rough_products() const { return rough_at(system_, impedance_->shift); }

void InverseOfMotionAtShift::settle(States& u) const { settle_velocities(system_, u); }

Matrix InverseOfMotionAtShift::shapes(const Matrix& states) const {
  Matrix both(system_.size(), 2 * states.cols());
  both << states.topRows(system_.size()), states.bottomRows(system_.size());
  return both;
}

}  // namespace gyromode::sparse
