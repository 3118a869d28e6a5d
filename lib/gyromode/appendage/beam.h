#pragma once

#include "gyromode/appendage/appendage.h"
#include "gyromode/appendage/parts.h"
#include "gyromode/appendage/bernoulli.h"

namespace gyromode {

/// With η = jY the transverse motion (X, η) relative to the body is real and falls apart into two cantilevers: ρN φ =
/// κEφ, N = [p t; t p], p = ω² + Ω², t = 2ωΩ, E the bending stiffnesses (docs/booms.md §4). Each feels the loads ρφᵀN
/// of the body's translation and rotation, and keeps one coordinate.
///
/// Where the first cantilever frequency is below the spin, the boom is soft: its fixed-root count then begins with what
/// the spin makes negative.
class BeamAppendage : public Appendage {
 public:
  BeamAppendage(const Beam& beam, double spin) : beam_(beam), spin_(spin), tip_ratio_(beam.tip_mass / (beam.line_density * beam.length)) {}

  Index coordinates() const override { return 2; }
  MassProperties rigid() const override;
  void couple(Couplings& to, Index first) const override;
  void add(double omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  void add(Complex omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  Eigen::Vector2cd first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const override;
  std::vector<Outline> outlines() const override;
  std::vector<ComplexMatrix> displaced(double omega, const ComplexVector& body, const ComplexVector& own) const override;

 private:
  template <class T>
  struct Cantilevers {
    T kappa[2];   // times l⁴
    T phi[2][2];  // φ_k of (X, η), φᵀEφ = 1
  };
  using Rows = Eigen::Matrix<Complex, 2, body_coordinates>;

  template <class T>
  Cantilevers<T> decoupled(const T& omega) const;
  template <class T>
  Rows loads(const T& omega, const T (&phi)[2], Complex j) const;
  template <class T>
  void add_to(const T& omega, Lifted& to, Index first) const;

  Beam beam_;
  double spin_;
  double tip_ratio_;  // ε/l
};

}  // namespace gyromode
