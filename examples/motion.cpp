// Motion over time without stepping: nutation of a spinning rigid body after an impulse, and at resonance.
//
// Boland & Janssens, ESA Journal 3 (1979), first example: small tilts θ1, θ2 from axes that turn steadily. A torque
// impulse p about axis 1 turns the angular momentum in space by p/(I₃Ω): the tilt mode, at ω = Ω. About it the body
// nutates at ω_n = Ω√((I₃ − I₁)(I₃ − I₂)/(I₁I₂)). Euler's equations and conservation of angular momentum give all of it
// in closed form:
//     rates        w1 = (p/I₁) cos ω_n t,   w2 = (p/I₁)(I₃ − I₁)Ω/(I₂ω_n) sin ω_n t
//     tilts        θ1 = (I₂w2 + p sin Ωt)/(I₃Ω),   θ2 = (p cos Ωt − I₁w1)/(I₃Ω)
#include "comparison.h"

#include <gyromode/gyromode.h>

#include <algorithm>
#include <numbers>

using namespace gyromode;

int main() {
  constexpr double i1 = 90, i2 = 110, i3 = 150, spin = 1.0471975511965976;  // kg m²; 10 rpm
  constexpr double p = 0.5, torque = 0.01;                                  // N m s, N m
  const double nutation = spin * std::sqrt((i3 - i1) * (i3 - i2) / (i1 * i2)), ratio = (i3 - i1) * spin / (i2 * nutation),
               g = (i1 + i2 - i3) * spin;
  const System body(Matrix{{i1, 0}, {0, i2}}, Matrix{{0, -g}, {g, 0}}, spin * spin * Matrix{{i3 - i2, 0}, {0, i3 - i1}}, {"θ1", "θ2"});
  const State rest{Vector::Zero(2), Vector::Zero(2)};
  const Vector about1 = Vector::Unit(2, 0);
  Comparison check;

  const Response kicked(body, rest, {{.course = Force::Course::impulse, .amplitude = p * about1}});
  std::printf("Shares of the modes after an impulse of %g N m s\n", p);
  check.equal("modes that take part", static_cast<double>(kicked.modal().size()), 2, 0);
  const ModalShare &slow = kicked.modal().at(0), &tilt = kicked.modal().at(1);
  check.equal("ω of the nutation [rad/s]", slow.omega, nutation, 1e-14);
  check.equal("its amplitude [rad]", slow.amplitude, p * std::max(1.0, i2 * ratio / i1) / (i3 * spin), 1e-13);
  check.equal("ω of the tilt [rad/s]", tilt.omega, spin, 1e-14);
  check.equal("its amplitude [rad]", tilt.amplitude, p / (i3 * spin), 1e-13);
  check.equal("energy of both [J]", slow.energy + tilt.energy, 0.5 * p * p / i1, 1e-13);

  std::printf("Tilts and energy over time\n");
  for (const double t : {1.0, 10.0, 100.0, 1000.0}) {
    const State w = kicked.at(t);
    const double w1 = p / i1 * std::cos(nutation * t), w2 = p / i1 * ratio * std::sin(nutation * t), rounding = 1e-14 * (10 + spin * t);
    const std::string at = " at t = " + std::to_string(static_cast<int>(t)) + " s";
    check.equal("θ1 [rad]" + at, w.q(0), (i2 * w2 + p * std::sin(spin * t)) / (i3 * spin), rounding);
    check.equal("θ2 [rad]" + at, w.q(1), (p * std::cos(spin * t) - i1 * w1) / (i3 * spin), rounding);
    check.equal("energy [J]" + at, kicked.energy(w), 0.5 * p * p / i1, rounding);
  }

  // A torque cos ω_n t from rest: w1 = torque/(2I₁)(t cos ω_n t + sin(ω_n t)/ω_n), growing as t. w1 = θ̇1 − Ωθ2: what a
  // gyro on the body measures.
  std::printf("Driven at resonance: rate about axis 1 at the peaks\n");
  const Response driven(body, rest, {{.course = Force::Course::harmonic, .amplitude = torque * about1, .frequency = slow.omega}});
  for (const int cycles : {1, 10, 100, 1000}) {
    const double t = 2 * std::numbers::pi * cycles / nutation;
    const State w = driven.at(t);
    check.equal("w1 [rad/s] after " + std::to_string(cycles) + " cycles", w.qdot(0) - spin * w.q(1), torque * t / (2 * i1), 1e-12);
  }
  return check.exit_code();
}
