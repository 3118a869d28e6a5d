#pragma once

#include "gyromode/appendage/appendage.h"
#include "gyromode/appendage/parts.h"
#include "gyromode/appendage/patterns.h"
#include "gyromode/appendage/pole.h"
#include "gyromode/appendage/wire_field.h"

namespace gyromode {

/// Equal cables, at any azimuths and heights: one field in plane and one out of plane serves all, and they move in
/// Patterns.
///
/// A wire at radius r, displaced in plane by u and out of plane by w relative to the body, feels the loads −ρ(U + rω
/// φ3) and −ρ(ω ξ3 + r(Ω² − ω²)θ_t), with U = e_tᵀ(Bξ + hN(θ2, −θ1)) and θ_t the rotation about e_t (docs/booms.md §3).
/// It answers with Legendre's functions of λ = 1 + ω²/Ω² and ω²/Ω².
class CableGroup : public Appendage {
 public:
  /// `cables` have the same_field().
  CableGroup(std::vector<Cable> cables, double spin);

  Index coordinates() const override { return 2 * count(); }
  MassProperties rigid() const override;
  void couple(Couplings& to, Index first) const override;
  void add(double omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  void add(Complex omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  Eigen::Vector2cd first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const override;
  std::vector<Outline> outlines() const override;
  std::vector<ComplexMatrix> displaced(double omega, const ComplexVector& body, const ComplexVector& own) const override;

 private:
  // Loads in units of the wire: U/√p and bφ3 in plane, ξ3 and b√p θ_t out of plane, times √m.
  template <class T>
  struct Answers {
    FieldResponse<T> in_plane, out_of_plane;
    T in_units[2], out_units[2];
    std::array<WireField<T>, 2> field;
  };

  struct Loads {
    Complex uniform, turn;  // U and θ_t
  };
  Loads loads_on(const Cable& c, double omega, const ComplexVector& body) const;
  Eigen::Matrix<Complex, 5, 1> in_plane_motions(double omega, const ComplexVector& body) const;
  Index count() const { return static_cast<Index>(cables_.size()); }
  std::vector<double> stations() const;  // z, from the tip
  template <class T>
  Answers<T> answers(const T& omega) const;
  template <class T>
  void add_to(const T& omega, Lifted& to, Index first) const;

  std::vector<Cable> cables_;
  double spin_;
  Cable one_;              // any of them, for the field
  double tip_mass_ratio_;  // μ
  double unit_;            // bc, of z
  double z_root_;          // z_a
  Patterns in_plane_;      // features (−sin α, cos α, −h sin α, h cos α, 1) of U and φ3
  Patterns out_of_plane_;  // features (−sin α, cos α, 1) of θ_t and ξ3
};

}  // namespace gyromode
