#include "gyromode/certificate/impedance.h"

#include "gyromode/dense/solve.h"
#include "gyromode/system/scale.h"

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

double Impedance::scale(double omega) const {
  return second_order_ ? norm_k_ + omega * (norm_g_ + omega * norm_m_) : omega * norm_m_ + norm_g_;
}

// First order: ωI − jG; T = diag(1, −j) turns it into [ωI₁, −B; −Bᵀ, ωI₂].
Inertia Impedance::negative_at(double omega) const {
  const double on_mass = second_order_ ? -omega * omega : omega;
  const double on_g = second_order_ ? omega : -1;
  if (quadrature()) {
    const Index p = m_rr_.rows();
    Matrix h(n_, n_);
    h.topLeftCorner(p, p) = k_rr_ + on_mass * m_rr_;
    h.bottomRightCorner(n_ - p, n_ - p) = k_ii_ + on_mass * m_ii_;
    h.topRightCorner(p, n_ - p) = on_g * g_ri_;
    h.bottomLeftCorner(n_ - p, p) = on_g * g_ri_.transpose();
    return inertia(h);
  }
  ComplexMatrix h(n_, n_);
  h.real() = k_rr_ + on_mass * m_rr_;
  h.imag() = on_g * g_ri_;
  return inertia(h);
}

}  // namespace gyromode
