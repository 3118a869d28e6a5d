// The tips of wire booms after a torque impulse on the body: SpacecraftResponse beside the exact fields of the wires.
//
//     example_wire_booms models/geos.toml
//
// GEOS (Boland & Janssens, ESA Journal 3, 1979) spins at 10 rpm with two wires of 20 m along ± its axis 2. An impulse p
// about axis 1 tilts the angular momentum by p/(J₃₃Ω) and sets the wires flapping. SpacecraftResponse has the wires as
// finite elements; find_modes() and impedance_at() have them as continua, by Legendre's functions: a mode ω, X of the
// exact H(ω) takes the amplitude 2|X (Xᴴf)| / |Xᴴ (dH/dω) X| from an impulse f.
#include "comparison.h"

#include <gyromode/gyromode.h>
#include <gyromode/models/spacecraft_model.h>
#include <gyromode/modes/spacecraft.h>
#include <gyromode/motion/spacecraft_response.h>

#include <algorithm>
#include <complex>

using namespace gyromode;

constexpr Index theta1 = 3, z1 = 8, z2 = 11;  // among zeta1 … theta3, x, y, z of the first tip, x, y, z of the second
constexpr double p = 1;                       // N m s

// Of θ1, from the exact impedance: dH/dω by differences of fourth order, steps 10⁻⁵ω.
double exact_amplitude(const Spacecraft& craft, const Mode& mode) {
  const double h = 1e-5 * mode.omega;
  const auto form = [&](double omega) { return mode.shape.dot(impedance_at(craft, omega) * mode.shape).real(); };
  const double slope =
      (8 * (form(mode.omega + h) - form(mode.omega - h)) - (form(mode.omega + 2 * h) - form(mode.omega - 2 * h))) / (12 * h);
  return 2 * std::norm(mode.shape(theta1)) * p / std::abs(slope);
}

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: example_wire_booms models/geos.toml\n"), 1;
  const Spacecraft craft = dynamic_cast<const SpacecraftModel&>(*read_model(argv[1]).body).spacecraft();
  const State rest{Vector::Zero(6), Vector::Zero(6)};
  const Force kick{.course = Force::Course::impulse, .amplitude = p * Vector::Unit(6, theta1)};
  const SpacecraftResponse motion(craft, rest, {kick}, {{BoomPoint::Part::cable, 1, 1}, {BoomPoint::Part::cable, 2, 1}});
  const Response& about_centre = motion.about_centre();
  Comparison check;

  std::printf("Modes up to 2 rad/s that take part, beside the exact fields\n");
  ModesOptions options;
  options.window = {0, 2};
  options.shapes = true;
  const ModesResult exact = find_modes(craft, options);
  check.holds("the exact modes are counted", exact.coverage.status == CoverageStatus::complete);
  int compared = 0;
  for (const ModalShare& share : motion.modal()) {
    if (share.omega > 2 || share.energy < 1e-10 * about_centre.initial_energy()) continue;
    const auto nearer = [&](const Mode& a, const Mode& b) { return std::abs(a.omega - share.omega) < std::abs(b.omega - share.omega); };
    const Mode& mode = *std::min_element(exact.modes.begin(), exact.modes.end(), nearer);
    check.equal("ω [rad/s]", share.omega, mode.omega, 1e-10);
    const bool tilt = mode.kind == ModeKind::rigid_body;
    const double of_body = tilt ? p / (craft.rigid().inertia()(2, 2) * craft.spin()) : exact_amplitude(craft, mode);
    check.equal(tilt ? "θ1 [rad], tilt of the angular momentum" : "θ1 [rad]", share.amplitude * std::abs(share.shape(theta1)), of_body,
                1e-8);
    const Complex tip = mode.field.front()(2, mode.field.front().cols() - 1);  // of a wire from root to tip, in the scale of the shape
    check.equal("tip along axis 3 [m]", share.amplitude * std::abs(share.shape(z1)), of_body * std::abs(tip / mode.shape(theta1)), 1e-8);
    ++compared;
  }
  check.equal("modes compared", compared, 4, 0);

  std::printf("Tip of the first wire along axis 3 [m], and the sum of all modal shares\n");
  for (double t = 5; t <= 60; t += 5) {
    const State w = motion.at(t);
    double sum = 0;
    for (const ModalShare& s : motion.modal()) sum += s.amplitude * (s.shape(z1) * std::polar(1.0, s.omega * t + s.phase)).real();
    check.equal("at t = " + std::to_string(static_cast<int>(t)) + " s", w.q(z1), sum, 1e-10);
    check.at_most("the other tip moves oppositely: |z1 + z2|/|z1|", std::abs((w.q(z1) + w.q(z2)) / w.q(z1)), 1e-9);
    check.equal("energy [J], now and at the start", about_centre.energy(about_centre.at(t)), about_centre.initial_energy(), 1e-9);
  }

  // The tension ½ρΩ²(b² − r²) carries the kick from the root at a to the tip at b in (√2/Ω) arccos(a/b). In elements
  // its front is not sharp: 2 %.
  const Cable& wire = craft.cables().front();
  const double largest = motion.at(Vector::LinSpaced(600, 0, 60)).q.row(z1).cwiseAbs().maxCoeff();
  double arrival = 0;
  while (arrival < 10 && std::abs(motion.at(arrival).q(z1)) < 0.01 * largest) arrival += 1e-3;
  const double exact_arrival = std::sqrt(2) / craft.spin() * std::acos(wire.radius / wire.reach());
  check.equal("the kick has reached the tip [s]: 1 % of its largest displacement", arrival, exact_arrival, 0.02);
  return check.exit_code();
}
