#include "gyromode/motion/reduced_sweep.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/indefinite.h"

namespace gyromode {

namespace {

constexpr Index more = 60;  // columns beyond the modes

}  // namespace

ReducedSweep::ReducedSweep(const SteadySolver& solver, ComplexVector force, const ComplexMatrix& shapes)
    : solver_(solver), force_(std::move(force)) {
  const Index most = shapes.cols() + more;
  basis_.resize(force_.size(), most);
  k_ = m_ = jg_ = ComplexMatrix::Zero(most, most);
  in_basis_.resize(most);
  for (Index k = 0; k < shapes.cols(); ++k) add(shapes.col(k));
  modes_ = size_;
}

// Orthogonalised twice; what is in the space already is not added.
void ReducedSweep::add(const ComplexVector& w) {
  if (size_ == basis_.cols() || !(w.norm() > 0)) return;
  constexpr double something = 1e-8;
  ComplexVector v = w.normalized();
  for (int pass = 0; pass < 2; ++pass) {
    v -= basis_.leftCols(size_) * (basis_.leftCols(size_).adjoint() * v);
    const double left = v.norm();
    if (!(left > something)) return;
    v /= left;
  }
  basis_.col(size_) = v;
  const Index n = ++size_;
  const auto space = basis_.leftCols(n);
  const SteadySolver::Products p = solver_.products(v);
  for (const auto& [product, to] : {std::pair(&p.k, &k_), {&p.m, &m_}, {&p.jg, &jg_}}) {
    const ComplexVector column = space.adjoint() * *product;
    to->col(n - 1).head(n) = column;
    to->row(n - 1).head(n) = column.adjoint();
    (*to)(n - 1, n - 1) = column(n - 1).real();
  }
  in_basis_(n - 1) = v.dot(force_);
}

ComplexVector ReducedSweep::projected(double omega) const {
  const auto part = [&](const ComplexMatrix& a) { return a.topLeftCorner(size_, size_); };
  const ComplexMatrix h = part(k_) - omega * omega * part(m_) + omega * part(jg_), right = in_basis_.head(size_);
  return basis_.leftCols(size_) * lapack::solve(lapack::factor_indefinite(h), right).col(0);
}

// Where corrections no longer get smaller, and are small, what is left is rounding: ε‖K‖‖q‖ in the residual, as of a
// solution by factors at ω itself.
ComplexVector ReducedSweep::at(double omega) {
  constexpr double accurate = 1e-11, rounding = 1e-7;
  constexpr int most_steps = 6;
  double before = infinity;
  for (int step = 0; near_ && size_ > 0 && step < most_steps; ++step) {
    const ComplexVector q = projected(omega), error = near_->solve(force_ - solver_.products(q).at(omega));
    const double left = error.norm() / q.norm();
    if (left <= accurate) return q + error;
    if (left <= rounding && left > 0.5 * before) return q;
    before = left;
    const Index columns = size_;
    add(error);
    if (size_ == columns) break;
  }
  near_ = solver_.factored(omega);
  ++factored_;
  if (size_ == basis_.cols()) size_ = modes_;  // what was needed elsewhere makes room
  ComplexVector q = near_->solve(force_);
  q += near_->solve(force_ - solver_.products(q).at(omega));
  add(q);
  return q;
}

}  // namespace gyromode
