#pragma once

#include "gyromode/certificate/inertia.h"
#include "gyromode/dense/spectrum.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// The impedance matrix of one component as it depends on ω, H(ω) = A₀ + ωA₁·j − ω²A₂, in the order of its Spectrum:
/// second order A₀ = K, A₁ = G, A₂ = M; first order H₁ = ωI − jG is taken as −ω-linear below. With a partition everything is real:
/// H* = T⁻¹HT, T = diag(1, −j) (Boland & Janssens 1979, Eqs. 10–12).
class Impedance {
 public:
  Impedance(const System& system, const dense::Spectrum& s);
  Impedance(const FirstOrderSystem& system, const dense::Spectrum& s);

  Index size() const { return n_; }
  bool quadrature() const { return split_ >= 0; }
  bool second_order() const { return second_order_; }

  /// n₋(H(ω)), ω > 0, from the real symmetric H* where there is a partition, else from the Hermitian H.
  Inertia negative_at(double omega) const;

  /// ‖K‖ + ω‖G‖ + ω²‖M‖ in 1-norms (‖G‖ + ω‖I‖ in first order): what residuals are relative to.
  double scale(double omega) const;

  /// The three real symmetric or skew matrices, restricted to the rows that carry the real (r) and the imaginary (i) parts of a shape. Without a partition
  /// both are all rows.
  const Matrix& stiffness_rr() const { return k_rr_; }
  const Matrix& stiffness_ii() const { return quadrature() ? k_ii_ : k_rr_; }
  const Matrix& mass_rr() const { return m_rr_; }
  const Matrix& mass_ii() const { return quadrature() ? m_ii_ : m_rr_; }
  const Matrix& gyroscopic_ri() const { return g_ri_; }

 private:
  void take(const Matrix& mass, const Matrix& gyroscopic, const Matrix* stiffness, const dense::Spectrum& s);

  Index n_ = 0;
  Index split_ = -1;
  bool second_order_ = true;
  Matrix k_rr_, k_ii_, m_rr_, m_ii_, g_ri_;
  double norm_k_ = 0, norm_g_ = 0, norm_m_ = 0;
};

}  // namespace gyromode
