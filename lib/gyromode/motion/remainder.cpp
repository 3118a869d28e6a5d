#include "gyromode/motion/remainder.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/motion/time_course.h"

#include <algorithm>
#include <cmath>
#include <random>

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

State Remainder::state(const Vector& y) const { return norm_->state(basis_ * y); }
Vector Remainder::coordinates(const State& w) const { return basis_.transpose() * norm_->coordinates(w); }

Remainder::Remainder(const ComponentMatrices& m, const EnergyNorm& norm, const ModalPart& modal, const ZeroPart& zero, Index dimension)
    : norm_(&norm), basis_(Matrix::Identity(2 * m.mass.rows(), dimension)) {
  constexpr unsigned seed = 1979;
  const Index whole = basis_.rows();
  if (dimension < whole) {
    std::mt19937_64 bits(seed);
    std::normal_distribution<double> normal;
    for (double& x : basis_.reshaped()) x = normal(bits);
    for (int pass = 0; pass < 2; ++pass) {  // the second takes out what an oblique projection left of the first
      for (auto x : basis_.colwise()) x = norm.coordinates(stripped(m, modal, zero, norm.state(x)));
      basis_ = small::orthonormal_columns(basis_);
    }
  }
  constexpr int corrections = 4;
  for (int step = 0; step < corrections; ++step) {
    const Matrix a = image(m);
    generator_ = basis_.transpose() * a;
    const Correction c = correction(m, modal, a - basis_ * generator_);
    if (step > 0 && !(c.size < 0.5 * departure_)) break;
    departure_ = c.size;
    basis_ = small::orthonormal_columns(Matrix(basis_ - c.basis));
  }
  generator_ = basis_.transpose() * image(m);
  take_rounding(m);
  recognise_double_root();
}

Matrix Remainder::image(const ComponentMatrices& m) const {
  Matrix a(basis_.rows(), basis_.cols());
  for (Index k = 0; k < basis_.cols(); ++k) {
    const State w = norm_->state(basis_.col(k));
    a.col(k) = norm_->coordinates({w.qdot, -norm_->accelerations(m.gyroscopic * w.qdot + m.stiffness * w.q)});
  }
  return a;
}

// A·basis − basis·B has parts r_s in the modes. The basis less Σ 2 Re w_s z_s, z_s(jω_s − B) = r_s, has none: with B =
// UTUᴴ, T triangular, z_s = (r_sU)(jω_s − T)⁻¹Uᴴ. What r leaves is in no mode, and counts relative to B.
Remainder::Correction Remainder::correction(const ComponentMatrices& m, const ModalPart& modal, Matrix departure) const {
  const Index d = size();
  const double rate = generator_.norm();
  ComplexMatrix r(modal.size(), d);
  for (Index k = 0; k < d; ++k) {
    r.col(k) = modal.amplitudes(m, norm_->state(departure.col(k)));
    departure.col(k) -= norm_->coordinates(modal.state(r.col(k)));
  }
  const double rest = departure.norm() / (rate > 0 ? rate : 1);
  const small::Schur schur = small::schur(generator_.cast<Complex>());
  ComplexMatrix z = r * schur.u;
  for (Index s = 0; s < modal.size(); ++s) {
    ComplexMatrix shifted = -schur.t;
    shifted.diagonal().array() += Complex(0, modal.omega()(s));
    z.row(s) = shifted.triangularView<Eigen::Upper>().solve<Eigen::OnTheRight>(z.row(s)).eval();
  }
  z = z * schur.u.adjoint();
  Correction c{Matrix::Zero(basis_.rows(), d), 0};
  for (Index k = 0; k < d; ++k) c.basis.col(k) = norm_->coordinates(modal.state(z.col(k)));
  c.size = std::max(c.basis.norm(), rest);
  if (!c.basis.allFinite()) c = {Matrix::Zero(basis_.rows(), d), infinity};
  return c;
}

// Entry by entry of xᵀAx, x = (Rq, Lᵀv): ε |v|ᵀ(|G||v| + 2|K||q|).
void Remainder::take_rounding(const ComponentMatrices& m) {
  Matrix q(m.mass.rows(), size()), v = q;
  for (Index k = 0; k < size(); ++k) {
    const State w = norm_->state(basis_.col(k));
    q.col(k) = w.q.cwiseAbs();
    v.col(k) = w.qdot.cwiseAbs();
  }
  const Matrix terms = v.transpose() * (m.gyroscopic.cwiseAbs() * v + 2 * m.stiffness.cwiseAbs() * q);
  rate_error_ = epsilon * (terms.norm() + generator_.norm());
}

// (A² + ω²)² = 0 with A = S + N, S² = −ω², N² = 0, SN = NS: then A² + ω² = 2SN, so N = −A(A² + ω²)/(2ω²).
void Remainder::recognise_double_root() {
  constexpr double coinciding = 1e-5;  // roots of a double pair are apart by √ε
  const Index d = generator_.rows();
  if (d < 4 || d % 2 != 0) return;
  const ComplexVector roots = small::eigenvalues(generator_);
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
  return small::exponential(generator_ * t);
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
  return small::exponential(a * t).col(d).head(d);
}

}  // namespace gyromode
