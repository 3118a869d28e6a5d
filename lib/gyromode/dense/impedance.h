#pragma once

#include "gyromode/dense/inertia.h"
#include "gyromode/spectrum/impedance.h"
#include "gyromode/spectrum/spectrum.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"
#include "gyromode/system/units.h"

#include <optional>

namespace gyromode::dense {

/// The impedance of one component as dense blocks, in the order of its Spectrum. Matrices, shapes and frequencies are
/// in the units of the component (units()): natural ones, or those given.
class Impedance : public gyromode::Impedance {
 public:
  /// In the units given.
  Impedance(const System& system, const Spectrum& s);
  Impedance(const FirstOrderSystem& system, const Spectrum& s);
  /// The coordinates `order` of the system (with a partition the first `split` in phase, else −1) in their natural
  /// units.
  static Impedance natural(const System& system, std::vector<Index> order, Index split);
  static Impedance natural(const FirstOrderSystem& system, std::vector<Index> order, Index split);

  /// The same system in coordinates whose last word on null(K) is exact: q = D B q̂, B unit triangular up to order, its
  /// columns for the free coordinates (RankedFactor) spanning null(K), so that K̂ has rows of exact zeros there. H(ω) is
  /// then known to full relative accuracy in every direction, however small ω and however graded K. Nothing where K is
  /// regular. Costs some products; order up to a few hundred.
  std::optional<Impedance> with_null_coordinates() const;

  Index size() const override { return static_cast<Index>(order_.size()); }
  const std::vector<Index>& order() const { return order_; }
  Index split() const override { return split_; }
  const Units& units() const { return units_; }
  bool second_order() const override { return second_order_; }

  /// H*(ω) and its slope −dH*/dω (dH₁*/dω in first order), real symmetric; only with a partition.
  Matrix real_at(double omega) const;
  Matrix real_slope_at(double omega) const;
  /// H(ω) and its slope 2ωM − jG (I in first order), Hermitian; only without a partition.
  ComplexMatrix complex_at(double omega) const;
  ComplexMatrix complex_slope_at(double omega) const;

  /// N(λ) = K + λG + λ²M and N′(λ) = G + 2λM, complex, second order only.
  ComplexMatrix characteristic_at(Complex lambda) const;
  ComplexMatrix characteristic_slope_at(Complex lambda) const;

  RowProducts products(const Matrix& re, const Matrix& im) const override;
  CharacteristicProducts characteristic_products(const ComplexMatrix& x) const override;
  ComplexMatrix form(const ComplexMatrix& x, double omega) const override;
  std::optional<DiscCount> roots_in_disc(Complex centre, double radius) const override;

  /// First order only: n₋(H₁(0⁺)) = ½ rank G, from the eigenvalues of −jG (its real form −B, −Bᵀ with a partition);
  /// those up to 8 n ε of the largest are zero.
  Index half_rank_of_gyroscopic() const;

  /// From the real symmetric H* where there is a partition, else from the Hermitian H.
  Inertia inertia_at(double omega) const override;

  /// A frequency of the size of the largest, in the unit of time given: max(√(‖K‖/‖M‖), ‖G‖/‖M‖).
  double typical_frequency() const;

  /// ‖K‖ + ω‖G‖ + ω²‖M‖ in 1-norms (‖G‖ + ω‖I‖ in first order) of the matrices in the units of the component, and in
  /// the units given: what reported residuals are relative to.
  double scale(double omega) const;
  double given_scale(double omega) const;
  double given_residual(const ComplexVector& r, const ComplexVector& x, double omega) const override;
  /// `s`, found in the units and coordinates of the component, in those given; and the zero shapes the other way round.
  void to_given(Spectrum& s) const;
  Matrix own_shapes(const Matrix& given) const;

  Vector weight(double omega) const override;
  /// weight(ω) where the coefficients were given; in null coordinates M and G are sums, and the sizes are those of the
  /// terms.
  Vector rounding_weight(double omega) const override;

  /// The three real symmetric or skew matrices, restricted to the rows that carry the real (r) and the imaginary (i)
  /// parts of a shape. Without a partition both are all rows.
  const Matrix& stiffness_rr() const { return k_rr_; }
  const Matrix& stiffness_ii() const { return quadrature() ? k_ii_ : k_rr_; }
  const Matrix& mass_rr() const { return m_rr_; }
  const Matrix& mass_ii() const { return quadrature() ? m_ii_ : m_rr_; }
  const Matrix& gyroscopic_ri() const { return g_ri_; }

 private:
  // What solvers do not need and certificates do, made when first asked for.
  struct Sizes {
    Vector k, g, m;                                // of entries in their own place: see weight()
    Vector terms_g, terms_m;                       // of the terms of sums: see rounding_weight(); g and m where nothing was summed
    double given_k = 0, given_g = 0, given_m = 0;  // norms of the matrices given, in the component's unit of time
  };

  Impedance(std::vector<Index> order, Index split, bool second_order)
      : order_(std::move(order)), split_(split), second_order_(second_order) {}
  Matrix star(double on_k, double on_m, double on_g) const;
  ComplexMatrix hermitian(double on_k, double on_m, double on_g) const;
  ComplexMatrix combined(Complex on_k, Complex on_g, Complex on_m) const;
  void take(const Matrix& mass, const Matrix& gyroscopic, const Matrix* stiffness, bool natural);
  void change_units();
  void measure_norms();
  const Sizes& sizes() const;

  std::vector<Index> order_;
  Index split_ = -1;
  bool second_order_ = true;
  Units units_;
  Matrix basis_;  // B, n × n, empty where it is 1
  Matrix k_rr_, k_ii_, m_rr_, m_ii_, g_ri_;
  double norm_k_ = 0, norm_g_ = 0, norm_m_ = 0;
  mutable std::optional<Sizes> sizes_;
};

}  // namespace gyromode::dense
