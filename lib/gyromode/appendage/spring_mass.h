#pragma once

#include "gyromode/appendage/appendage.h"
#include "gyromode/appendage/parts.h"

namespace gyromode {

/// Its displacement u relative to the body is kept, over √(k + m(ω² + Ω²)) in each direction so that stiff and light
/// ones weigh alike: diag(k) − mN₃ on u, and with the body
///     −m N₃ (ζ + θ × p) + mΩ² θ × Pp,   N₃ = [p jt 0; −jt p 0; 0 0 ω²],   P = diag(1, 1, 0),
/// the second from the centrifugal force that the springs carry.
class SpringMassAppendage : public Appendage {
 public:
  SpringMassAppendage(const SpringMass& mass, double spin);

  Index coordinates() const override { return static_cast<Index>(sprung_.size()); }
  MassProperties rigid() const override { return MassProperties::point(mass_.mass, mass_.position); }
  void couple(Couplings& to, Index first) const override;
  void add(double omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  void add(Complex omega, Lifted& to, Index first) const override { add_to(omega, to, first); }
  Eigen::Vector2cd first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const override;
  std::vector<Outline> outlines() const override { return {{"mass on springs", {mass_.position}}}; }
  std::vector<ComplexMatrix> displaced(double omega, const ComplexVector& body, const ComplexVector& own) const override;

 private:
  double scale(double omega, Index a) const;
  static double scale(const Complex&, Index) { return 1; }  // analytic
  template <class T>
  void add_to(const T& omega, Lifted& to, Index first) const;

  SpringMass mass_;
  double spin_;
  std::vector<Index> sprung_;  // directions with a spring
};

}  // namespace gyromode
