#include "support/random_spacecraft.h"
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/spring_mass.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace gyromode {

namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double a, double b) { return a + (b - a) * std::uniform_real_distribution<double>(0, 1)(engine_); }
  double decades(double a, double b) { return std::exp(between(std::log(a), std::log(b))); }
  int whole(int a, int b) { return std::uniform_int_distribution<int>(a, b)(engine_); }
  bool chance(double p) { return between(0, 1) < p; }

 private:
  std::mt19937_64 engine_;
};

Cable random_cable(Draw& d, double size) {
  Cable c;
  c.length = size * d.decades(0.3, 3);
  c.radius = d.chance(0.1) ? 1e-4 * c.length : c.length * d.decades(0.01, 1);
  c.height = d.chance(0.3) ? 0 : 0.3 * size * d.between(-1, 1);
  c.line_density = d.decades(0.001, 0.05);
  c.tip_mass = d.chance(0.4) ? 0 : c.line_density * c.length * d.between(0, 10);
  return c;
}

// Rings of two to four equal wires, all turned by any angle.
std::vector<Cable> rings(Draw& d, double size) {
  std::vector<Cable> all;
  const int count = d.whole(1, 3);
  for (int ring = 0; ring < count && all.size() < 6; ++ring) {
    Cable c = random_cable(d, size);
    const int wires = all.empty() && d.chance(0.5) ? 4 : 2;
    const double turn = d.chance(0.5) ? 0.5 * std::numbers::pi * d.whole(0, 3) : d.between(0, 2 * std::numbers::pi);
    for (int k = 0; k < wires; ++k) {
      c.azimuth = turn + 2 * std::numbers::pi * k / wires;
      all.push_back(c);
    }
  }
  return all;
}

// All sorts, the last one such that the mass centre is on the axis.
std::vector<Cable> all_sorts(Draw& d, double size) {
  std::vector<Cable> all;
  const int count = d.whole(2, 7);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int k = 0; k < count; ++k) {
    Cable c = random_cable(d, size);
    c.azimuth = 2 * std::numbers::pi * (k + d.between(-0.3, 0.3)) / (count + 1);
    moment += c.first_moment() * c.direction();
    all.push_back(c);
  }
  Cable last = random_cable(d, size);
  last.azimuth = std::atan2(-moment(1), -moment(0));
  const double factor = moment.norm() / last.first_moment();
  last.line_density *= factor;
  last.tip_mass *= factor;
  all.push_back(last);
  return all;
}

Beam random_beam(Draw& d, double size, double spin, bool upward) {
  Beam b;
  b.upward = upward;
  b.root_height = size * d.between(0, 0.2) * b.way();
  b.length = size * d.decades(0.3, 1);
  b.line_density = d.decades(0.02, 0.3);
  b.tip_mass = d.chance(0.5) ? 0 : b.line_density * b.length * d.between(0, 2);
  // First frequency some times the spin: κ₁l⁴ = 12.4 without a tip mass.
  const double first = spin * d.decades(1.5, 10);
  const double stiffness = (b.line_density * b.length + 4 * b.tip_mass) * std::pow(b.length, 3) * first * first / 12.4;
  b.bending_stiffness[0] = stiffness;
  b.bending_stiffness[1] = d.chance(0.4) ? stiffness : stiffness * d.between(0.7, 1.5);
  return b;
}

SpringMass random_mass(Draw& d, double size, double spin, bool on_axis) {
  SpringMass m;
  m.mass = d.decades(0.2, 5);
  for (double& x : m.position) x = 0.3 * size * d.between(-1, 1);
  if (on_axis) m.position.head<2>().setZero();
  for (double& k : m.stiffness) {
    const double ratio = d.decades(1.5, 8);
    k = d.chance(0.25) ? std::numeric_limits<double>::infinity() : m.mass * spin * spin * ratio * ratio;
  }
  return m;
}

}  // namespace

Spacecraft random_spacecraft(std::uint64_t seed) {
  Draw d(seed);
  const double size = d.decades(1, 30), spin = d.decades(0.05, 5);
  std::vector<SpringMass> masses;
  if (d.chance(0.3)) masses.push_back(random_mass(d, size, spin, true));
  if (d.chance(0.2)) {
    masses.push_back(random_mass(d, size, spin, false));
    masses.push_back(masses.back());
    masses.back().position.head<2>() *= -1;
  }
  std::vector<Beam> beams;
  if (d.chance(0.4)) beams.push_back(random_beam(d, size, spin, true));
  if (d.chance(0.2)) beams.push_back(random_beam(d, size, spin, false));
  const std::vector<Cable> cables = d.chance(0.5) ? rings(d, size) : all_sorts(d, size);
  // The body: a multiple of what the booms have, with the products of inertia that balance them.
  MassProperties booms;
  for (const Cable& c : cables) booms += CableGroup({c}, spin).rigid();
  for (const Beam& b : beams) booms += BeamAppendage(b, spin).rigid();
  for (const SpringMass& m : masses) booms += MassProperties::point(m.mass, m.position);
  const Eigen::Matrix3d theirs = booms.inertia();
  const double scale = theirs(2, 2) * d.decades(0.2, 5) + 3 * std::hypot(theirs(0, 2), theirs(1, 2));
  double moments[3] = {d.between(0.7, 0.95), d.between(0.95, 1.1), d.between(1.1, 1.5)};
  if (d.chance(0.25)) std::swap(moments[0], moments[2]);
  if (d.chance(0.2)) std::swap(moments[1], moments[2]);
  Body body;
  body.mass = booms.mass * d.decades(3, 300);
  body.inertia = scale * Eigen::Vector3d(moments[0], moments[1], moments[2]).asDiagonal();
  if (d.chance(0.3)) body.inertia(0, 1) = body.inertia(1, 0) = 0.05 * scale;
  body.inertia(0, 2) = body.inertia(2, 0) = -theirs(0, 2);
  body.inertia(1, 2) = body.inertia(2, 1) = -theirs(1, 2);
  return Spacecraft(spin, body, cables, beams, masses);
}

}  // namespace gyromode
