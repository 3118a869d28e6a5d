#include "gyromode/dense/impedance.h"

#include "gyromode/dense/solve.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

Impedance::Impedance(const System& system, const dense::Spectrum& s) : second_order_(true) {
  take(system.mass(), system.gyroscopic(), &system.stiffness(), s);
}

Impedance::Impedance(const FirstOrderSystem& system, const dense::Spectrum& s) : second_order_(false) {
  take(system.inertia(), system.gyroscopic(), nullptr, s);
}

void Impedance::take(const Matrix& mass, const Matrix& gyroscopic, const Matrix* stiffness, const dense::Spectrum& s) {
  n_ = s.size();
  split_ = s.split;
  const std::vector<Index> real(s.order.begin(), split_ < 0 ? s.order.end() : s.order.begin() + split_);
  const std::vector<Index> imaginary = split_ < 0 ? real : std::vector<Index>(s.order.begin() + split_, s.order.end());
  m_rr_ = dense::restricted(mass, real, real);
  g_ri_ = dense::restricted(gyroscopic, real, imaginary);
  k_rr_ = stiffness ? dense::restricted(*stiffness, real, real) : Matrix::Zero(m_rr_.rows(), m_rr_.rows());
  norm_m_ = norm1(m_rr_);
  norm_k_ = norm1(k_rr_);
  norm_g_ = norm1(g_ri_);
  if (split_ < 0) return;
  m_ii_ = dense::restricted(mass, imaginary, imaginary);
  k_ii_ = stiffness ? dense::restricted(*stiffness, imaginary, imaginary) : Matrix::Zero(m_ii_.rows(), m_ii_.rows());
  norm_m_ = std::max(norm_m_, norm1(m_ii_));
  norm_k_ = std::max(norm_k_, norm1(k_ii_));
  norm_g_ = std::max(norm_g_, norm1(Matrix(g_ri_.transpose())));
}

double Impedance::typical_frequency() const { return std::max(std::sqrt(norm_k_ / norm_m_), norm_g_ / norm_m_); }

double Impedance::scale(double omega) const {
  return second_order_ ? norm_k_ + omega * (norm_g_ + omega * norm_m_) : omega * norm_m_ + norm_g_;
}

// [on_k K₁ + on_m M₁, on_g B; ·, on_k K₂ + on_m M₂]
Matrix Impedance::star(double on_k, double on_m, double on_g) const {
  const Index p = m_rr_.rows();
  Matrix h(n_, n_);
  h.topLeftCorner(p, p) = on_k * k_rr_ + on_m * m_rr_;
  h.bottomRightCorner(n_ - p, n_ - p) = on_k * k_ii_ + on_m * m_ii_;
  h.topRightCorner(p, n_ - p) = on_g * g_ri_;
  h.bottomLeftCorner(n_ - p, p) = on_g * g_ri_.transpose();
  return h;
}

// on_k K + on_m M + j on_g G
ComplexMatrix Impedance::hermitian(double on_k, double on_m, double on_g) const {
  ComplexMatrix h(n_, n_);
  h.real() = on_k * k_rr_ + on_m * m_rr_;
  h.imag() = on_g * g_ri_;
  return h;
}

// T⁻¹(jωG)T has the blocks ωB and ωBᵀ; T⁻¹(−jG)T has −B and −Bᵀ.
Matrix Impedance::real_at(double omega) const { return second_order_ ? star(1, -omega * omega, omega) : star(0, omega, -1); }
Matrix Impedance::real_slope_at(double omega) const { return second_order_ ? star(0, 2 * omega, -1) : star(0, 1, 0); }
ComplexMatrix Impedance::complex_at(double omega) const { return second_order_ ? hermitian(1, -omega * omega, omega) : hermitian(0, omega, -1); }
ComplexMatrix Impedance::complex_slope_at(double omega) const { return second_order_ ? hermitian(0, 2 * omega, -1) : hermitian(0, 1, 0); }

ComplexMatrix Impedance::combined(Complex on_k, Complex on_g, Complex on_m) const {
  if (!quadrature()) return on_k * k_rr_ + on_g * g_ri_ + on_m * m_rr_;
  const Index r = n_ - split_;
  ComplexMatrix a(n_, n_);
  a.topLeftCorner(split_, split_) = on_k * k_rr_ + on_m * m_rr_;
  a.bottomRightCorner(r, r) = on_k * k_ii_ + on_m * m_ii_;
  a.topRightCorner(split_, r) = on_g * g_ri_;
  a.bottomLeftCorner(r, split_) = -on_g * g_ri_.transpose();
  return a;
}

ComplexMatrix Impedance::characteristic_at(Complex lambda) const { return combined(1, lambda, lambda * lambda); }
ComplexMatrix Impedance::characteristic_slope_at(Complex lambda) const { return combined(0, 1, 2.0 * lambda); }

ComplexMatrix Impedance::form(const ComplexMatrix& x, double omega) const {
  if (!quadrature()) return x.adjoint() * (complex_slope_at(omega) * x);
  ComplexMatrix star = x;  // X* = T⁻¹X
  star.bottomRows(n_ - split_) *= Complex(0, 1);
  return star.adjoint() * (real_slope_at(omega) * star);
}

Index Impedance::half_rank_of_gyroscopic() const {
  return quadrature() ? clearly_negative(star(0, 0, -1)) : clearly_negative(hermitian(0, 0, -1));
}

Inertia Impedance::negative_at(double omega) const { return quadrature() ? inertia(real_at(omega)) : inertia(complex_at(omega)); }

}  // namespace gyromode
