// The impedance matrix H(ω) = K − ω²M + jωG made real symmetric, H* = UᴴHU, in the three ways of realify(); and n₋(H*)
// as a count of modes.
//
// Boland & Janssens, ESA Journal 3 (1979): T = diag(1, −j), Eqs. 10–12, and S(ψ), Eqs. 16–19. Their asymmetric body,
// spinning at 100 rad/s, hangs on two elastic hinges that turn with it: along its principal axes T serves at every ω;
// turned by φ from them, the angle ψ depends on ω. The third way, Householder reflections, serves any n: a pipe on two
// supports that carries water (Païdoussis, Fluid–Structure Interactions 1, 1998, ch. 3) by five sine functions, with a
// spring at 0.3 of its length. K > 0 in all three, so that n₋(H(ω)) is the number of modes below ω.
#include "comparison.h"

#include <gyromode/gyromode.h>

#include <algorithm>
#include <numbers>

using namespace gyromode;

constexpr double pi = std::numbers::pi;
constexpr double i1 = 8e-4, i2 = 10e-4, i3 = 15e-4, spin = 100, k1 = 4, k2 = 1;  // kg m², rad/s, N m/rad

System hinged_body(double phi) {
  const double c = std::cos(phi), s = std::sin(phi), g = (i1 + i2 - i3) * spin, k12 = (k1 - k2) * s * c;
  return {Matrix{{i1, 0}, {0, i2}}, Matrix{{0, -g}, {g, 0}},
          Matrix{{spin * spin * (i3 - i2) + k1 * c * c + k2 * s * s, k12}, {k12, spin * spin * (i3 - i1) + k1 * s * s + k2 * c * c}}};
}

System pipe_with_spring() {
  constexpr double length = 2, bending = 900, pipe = 0.7, water = 0.5, speed = 30, spring = 2e4;  // m, N m², kg/m, kg/m, m/s, N/m
  Matrix g = Matrix::Zero(5, 5), k = g;
  for (int i = 1; i <= 5; ++i) {
    const double wave = i * pi / length;
    k(i - 1, i - 1) = length / 2 * (bending * std::pow(wave, 4) - water * speed * speed * wave * wave);
    for (int l = 1; l <= 5; ++l) {
      if ((i + l) % 2 != 0) g(i - 1, l - 1) = 4 * water * speed * i * l / (i * i - l * l);
      k(i - 1, l - 1) += spring * std::sin(0.3 * pi * i) * std::sin(0.3 * pi * l);
    }
  }
  return {(pipe + water) * length / 2 * Matrix::Identity(5, 5), g, k};
}

void compare(Comparison& check, const System& system, double omega, const Realified& real) {
  const std::vector<Mode> modes = find_modes(system).modes;
  const auto below = std::count_if(modes.begin(), modes.end(), [&](const Mode& m) { return m.omega < omega; });
  check.equal("n₋(H*), and modes below ω", static_cast<double>(real.negative()), static_cast<double>(below), 0);
  const ComplexMatrix &h = real.impedance, &u = real.unitary;
  const double change = (u.adjoint() * h * u - real.real_symmetric).norm() / h.norm(),
               unity = (u.adjoint() * u - Matrix::Identity(u.rows(), u.cols())).norm();
  check.at_most("‖UᴴHU − H*‖/‖H‖ + ‖UᴴU − 1‖", change + unity, 1e-14);
}

int main() {
  Comparison check;
  std::printf("T: hinges along the principal axes\n");
  const System plain = hinged_body(0);
  const Realified by_t = realify(plain.impedance(110), analyse(plain));
  check.holds("T of a partition was taken", by_t.how == Realification::partition);
  check.equal("H*₁₂ = ωG₁₂", by_t.real_symmetric(0, 1), -110 * (i1 + i2 - i3) * spin, 1e-15);
  compare(check, plain, 110, by_t);

  // tan 2ψ = 2c/(a − d): ψ falls from 50° to 0 and passes 45°, where ½ arctan jumps by 90°. Handed on, it does not; at
  // ω = spin it is φ itself.
  std::printf("S(ψ): hinges turned by φ = 30°\n");
  const System turned = hinged_body(pi / 6);
  const Structure structure = analyse(turned);
  const auto exact = [](double omega) {
    return std::atan2((k1 - k2) * std::sin(pi / 3), (k1 - k2) * std::cos(pi / 3) + (spin * spin - omega * omega) * (i1 - i2)) / 2;
  };
  double psi = pi / 6;
  for (double omega = 0; omega <= 200; omega += 25) {
    const Realified real = realify(turned.impedance(omega), structure, psi);
    psi = real.angle.value();
    check.equal("ψ [°] at ω = " + std::to_string(static_cast<int>(omega)) + " rad/s", psi * 180 / pi, exact(omega) * 180 / pi, 1e-13);
    compare(check, turned, omega, real);
  }
  const Realified alone = realify(turned.impedance(25), structure);
  check.equal("ψ [°] at ω = 25 rad/s, not handed on: another branch", alone.angle.value() * 180 / pi, exact(25) * 180 / pi - 90, 1e-13);

  std::printf("Reflections: pipe with water and a spring, n = 5, at ω = 50, 200, 500, 1000, 2000 rad/s\n");
  const System pipe = pipe_with_spring();
  check.holds("reflections were taken", realify(pipe.impedance(50), analyse(pipe)).how == Realification::tridiagonal);
  for (const double omega : {50, 200, 500, 1000, 2000}) compare(check, pipe, omega, realify(pipe.impedance(omega), analyse(pipe)));
  return check.exit_code();
}
