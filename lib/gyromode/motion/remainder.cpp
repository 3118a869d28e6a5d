#include "gyromode/motion/remainder.h"

#include "gyromode/motion/time_course.h"
#include "gyromode/system/scale.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>

namespace gyromode {

State stripped(const ComponentMatrices& m, const ModalPart& modal, const ZeroPart& zero, State w) {
  for (int pass = 0; pass < 2; ++pass) {
    const State on_modes = modal.state(modal.amplitudes(m, w));
    const State on_zero = zero.state(zero.coordinates(m, w));
    w.q -= on_modes.q + on_zero.q;
    w.qdot -= on_modes.qdot + on_zero.qdot;
  }
  return w;
}

Vector Remainder::scaled(const State& w) const {
  Vector x(2 * w.q.size());
  x << w.q.cwiseQuotient(scale_), w.qdot.cwiseQuotient(scale_) / unit_;
  return x;
}

State Remainder::state(const Vector& y) const {
  const Index n = scale_.size();
  const Vector x = basis_ * y;
  return {x.head(n).cwiseProduct(scale_), unit_ * x.tail(n).cwiseProduct(scale_)};
}

Vector Remainder::coordinates(const State& w) const { return basis_.transpose() * scaled(w); }

Remainder::Remainder(const ComponentMatrices& m, const ModalPart& modal, const ZeroPart& zero, Index dimension, double unit_frequency, const std::vector<State>& starts)
    : scale_(unit_diagonal_scale(m.mass)), unit_(unit_frequency), basis_(2 * m.mass.rows(), 0) {
  constexpr double independent = 1e-10;  // what is left of a unit vector beside the basis: less is rounding
  const Eigen::LLT<Matrix> mass(m.mass);
  const Index n = m.mass.rows();
  const auto rate = [&](const State& w) -> State { return {w.qdot, -mass.solve(m.gyroscopic * w.qdot + m.stiffness * w.q)}; };
  const auto unscaled = [&](const Vector& x) -> State { return {x.head(n).cwiseProduct(scale_), unit_ * x.tail(n).cwiseProduct(scale_)}; };
  const auto take = [&](Vector x) {
    const double length = x.norm();
    if (!(length > 0) || basis_.cols() == dimension) return;
    x /= length;
    for (int pass = 0; pass < 2; ++pass) x -= basis_ * (basis_.transpose() * x);
    if (!(x.norm() > independent)) return;
    basis_.conservativeResize(Eigen::NoChange, basis_.cols() + 1);
    basis_.rightCols(1) = x.normalized();
  };
  for (const State& w : starts) take(scaled(stripped(m, modal, zero, w)));
  for (Index k = 0; k < basis_.cols() && basis_.cols() < dimension; ++k) take(scaled(stripped(m, modal, zero, rate(unscaled(basis_.col(k))))));
  Matrix image(2 * n, basis_.cols());
  for (Index k = 0; k < basis_.cols(); ++k) image.col(k) = scaled(rate(unscaled(basis_.col(k))));
  generator_ = basis_.transpose() * image;
  recognise_double_root();
}

// (A² + ω²)² = 0 with A = S + N, S² = −ω², N² = 0, SN = NS: then A² + ω² = 2SN, so N = −A(A² + ω²)/(2ω²).
void Remainder::recognise_double_root() {
  constexpr double coinciding = 1e-5;  // roots of a double pair are apart by √ε
  const Index d = generator_.rows();
  if (d < 4 || d % 2 != 0) return;
  const ComplexVector roots = Eigen::EigenSolver<Matrix>(generator_, false).eigenvalues();
  const Matrix square = generator_ * generator_;
  const double omega2 = -square.trace() / static_cast<double>(d);
  if (!(omega2 > 0)) return;
  const double omega = std::sqrt(omega2);
  for (const Complex& root : roots) {
    if (!(std::abs(Complex(std::abs(root.real()), std::abs(root.imag()) - omega)) <= coinciding * omega)) return;
  }
  double_root_ = omega;
  nilpotent_ = -generator_ * (square + omega2 * Matrix::Identity(d, d)) / (2 * omega2);
  semisimple_ = generator_ - nilpotent_;
}

Matrix Remainder::exponential(double t) const {
  if (double_root_ > 0) {
    const Matrix one = Matrix::Identity(size(), size());
    return (std::cos(double_root_ * t) * one + std::sin(double_root_ * t) / double_root_ * semisimple_) * (one + t * nilpotent_);
  }
  return (generator_ * t).exp();
}

Vector Remainder::moved(const Vector& y, double t) const { return size() == 0 ? y : Vector(exponential(t) * y); }

// (y, cos νt, sin νt) obeys a linear system without input.
Vector Remainder::driven(const Vector& g, double nu, double t) const {
  const Index d = size();
  if (d == 0) return g;
  if (double_root_ > 0) {  // ∫ (cos ωτ + S sin ωτ/ω)(1 + τN) g cos ν(t − τ) dτ
    const Complex once = forced(double_root_, nu, t), twice = forced_twice(double_root_, nu, t);
    const Vector sg = semisimple_ * g / double_root_, ng = nilpotent_ * g;
    return once.real() * g + once.imag() * sg + twice.real() * ng + twice.imag() * (semisimple_ * ng / double_root_);
  }
  Matrix a = Matrix::Zero(d + 2, d + 2);
  a.topLeftCorner(d, d) = generator_;
  a.col(d).head(d) = g;
  a(d, d + 1) = -nu;
  a(d + 1, d) = nu;
  return Matrix((a * t).exp()).col(d).head(d);
}

}  // namespace gyromode
