#pragma once

#include "gyromode/spectrum/inertia.h"

#include <optional>

namespace gyromode {

/// KX, MX and jGX of shapes X = re + j im, real and imaginary parts, of each the rows that carry it: jGX = −G_ri im + j
/// G_ir re, G_ir = −G_riᵀ.
struct RowProducts {
  Matrix k_re, k_im, m_re, m_im, g_re, g_im;
};

/// KX, GX and MX for every column of X (n × u, complex): N(λ)X = KX + λGX + λ²MX. Empty for no columns.
struct CharacteristicProducts {
  ComplexMatrix k, g, m;
};

/// Roots of det N(λ) in a disc, with multiplicity.
struct DiscCount {
  Index roots = 0;
  Complex mean;  ///< of the roots inside
};

/// What a certificate needs of the impedance matrix of one component, H(ω) = K − ω²M + jωG, or H₁(ω) = ωI − jG in first
/// order, in whatever storage. Measuring, energy signs, exhibits and verdicts (certificate/) are written on it. With a
/// partition into in phase and in quadrature everything is real: H* = T⁻¹HT, T = diag(1, −j) (Boland & Janssens 1979,
/// Eqs. 10–12), and shapes are stored by the rows that carry their real and their imaginary parts: the first split()
/// and the others. Without one both have all rows.
///
/// Matrices, shapes and frequencies are in units of the implementation's choice, in which they are of moderate size.
class Impedance {
 public:
  virtual ~Impedance() = default;

  virtual Index size() const = 0;
  virtual Index split() const = 0;  ///< number of coordinates in phase, which come first; −1 without a partition
  bool quadrature() const { return split() >= 0; }
  virtual bool second_order() const = 0;

  virtual RowProducts products(const Matrix& re, const Matrix& im) const = 0;
  virtual CharacteristicProducts characteristic_products(const ComplexMatrix& x) const = 0;
  /// Xᴴ H′(ω) X, H′ = 2ωM − jG (I in first order), for any complex shapes X (n × c); Hermitian c × c.
  virtual ComplexMatrix form(const ComplexMatrix& x, double omega) const = 0;

  /// n₋(H(ω)), ω > 0. No ω is too large or too small for it.
  virtual Inertia inertia_at(double omega) const = 0;
  /// The number of roots with |λ − centre| < radius, second order; nothing where a root is near the circle.
  virtual std::optional<DiscCount> roots_in_disc(Complex centre, double radius) const = 0;

  /// weight_i(ω) = κ_i + ωg_i + ω²m_i (g_i + ωm_i in first order), κ such that entry by entry |K_ik| ≤ √(κ_i κ_k), with
  /// equality up to a factor of two somewhere in each row; likewise for G and M. A backward error of η in every
  /// coefficient, each in its own scale, changes xᴴHx by at most about η Σ weight_i |x_i|². Changes of units leave it
  /// as it is.
  virtual Vector weight(double omega) const = 0;
  /// The same for what the coefficients were computed from: a rounding error of ε in every operation that made them
  /// changes xᴴHx by at most some ε Σ rounding_weight_i |x_i|².
  virtual Vector rounding_weight(double omega) const = 0;
  /// ‖r‖₂ / ((‖K‖ + ω‖G‖ + ω²‖M‖)‖x‖₂), 1-norms of matrices, everything in the units and coordinates given, for r =
  /// H(ω)x in those of the implementation.
  virtual double given_residual(const ComplexVector& r, const ComplexVector& x, double omega) const = 0;
};

}  // namespace gyromode
