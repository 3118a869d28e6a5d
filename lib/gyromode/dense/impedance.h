#pragma once

#include "gyromode/dense/inertia.h"
#include "gyromode/dense/spectrum.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

namespace gyromode {

/// The impedance matrix of one component in the order of its Spectrum: H(ω) = K − ω²M + jωG, or H₁(ω) = ωI − jG in first order. With a partition
/// everything is real: H* = T⁻¹HT, T = diag(1, −j) (Boland & Janssens 1979, Eqs. 10–12).
class Impedance {
 public:
  Impedance(const System& system, const dense::Spectrum& s);
  Impedance(const FirstOrderSystem& system, const dense::Spectrum& s);

  Index size() const { return n_; }
  bool quadrature() const { return split_ >= 0; }
  bool second_order() const { return second_order_; }

  /// H*(ω) and its slope −dH*/dω (dH₁*/dω in first order), real symmetric; only with a partition.
  Matrix real_at(double omega) const;
  Matrix real_slope_at(double omega) const;
  /// H(ω) and its slope 2ωM − jG (I in first order), Hermitian; only without a partition.
  ComplexMatrix complex_at(double omega) const;
  ComplexMatrix complex_slope_at(double omega) const;

  /// N(λ) = K + λG + λ²M and N′(λ) = G + 2λM, complex, second order only.
  ComplexMatrix characteristic_at(Complex lambda) const;
  ComplexMatrix characteristic_slope_at(Complex lambda) const;

  /// Xᴴ H′(ω) X with H′ the slope above, for any complex shapes X (n × c) in the order of the Spectrum; Hermitian c × c.
  ComplexMatrix form(const ComplexMatrix& x, double omega) const;

  /// First order only: n₋(H₁(0⁺)) = ½ rank G, from the eigenvalues of −jG (its real form −B, −Bᵀ with a partition); those up to 8 n ε of the largest are zero.
  Index half_rank_of_gyroscopic() const;

  /// n₋(H(ω)), ω > 0, from the real symmetric H* where there is a partition, else from the Hermitian H.
  Inertia negative_at(double omega) const;

  /// A frequency of the size of the largest: max(√(‖K‖/‖M‖), ‖G‖/‖M‖).
  double typical_frequency() const;

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
  Matrix star(double on_k, double on_m, double on_g) const;
  ComplexMatrix hermitian(double on_k, double on_m, double on_g) const;
  ComplexMatrix combined(Complex on_k, Complex on_g, Complex on_m) const;
  void take(const Matrix& mass, const Matrix& gyroscopic, const Matrix* stiffness, const dense::Spectrum& s);

  Index n_ = 0;
  Index split_ = -1;
  bool second_order_ = true;
  Matrix k_rr_, k_ii_, m_rr_, m_ii_, g_ri_;
  double norm_k_ = 0, norm_g_ = 0, norm_m_ = 0;
};

}  // namespace gyromode
