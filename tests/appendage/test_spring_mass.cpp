// A mass on springs against its Lagrangian: M, G, K of the nine coordinates (ζ, θ, u) by differences of the exact
// kinetic energy in 50 digits, with the rotation by Rodrigues' formula; then condensed.
#include "gyromode/appendage/hub_impedance.h"
#include "gyromode/appendage/spring_mass.h"
#include "gyromode/lapack/small.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <array>
#include <limits>

namespace gyromode {
namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Vector3 = std::array<Real, 3>;
using State = std::array<Real, 18>;  // ζ, θ, u and their rates

Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// ζ + A(θ)(p + u), A x = x + s θ×x + c θ×(θ×x), s = sin|θ|/|θ|, c = (1 − cos|θ|)/|θ|² by their series.
Vector3 place(const SpringMass& m, const std::array<Real, 9>& q) {
  const Vector3 theta{q[3], q[4], q[5]};
  Vector3 x;
  for (int i = 0; i < 3; ++i) x[i] = Real(m.position(i)) + q[6 + i];
  const Real square = theta[0] * theta[0] + theta[1] * theta[1] + theta[2] * theta[2];
  const Real s = 1 - square / 6 + square * square / 120;
  const Real c = Real(1) / 2 - square / 24 + square * square / 720;
  const Vector3 once = cross(theta, x);
  const Vector3 twice = cross(theta, once);
  Vector3 r;
  for (int i = 0; i < 3; ++i) r[i] = q[i] + x[i] + s * once[i] + c * twice[i];
  return r;
}

// L = ½m|Ṙ + Ω × R|² − ½Σk u² − f·u, f the force of the deflected springs.
Real lagrangian(const SpringMass& m, double spin, const State& z) {
  std::array<Real, 9> q;
  std::array<Real, 9> ahead, behind;
  const Real step("1e-16");
  for (int i = 0; i < 9; ++i) {
    q[i] = z[i];
    ahead[i] = z[i] + step * z[9 + i];
    behind[i] = z[i] - step * z[9 + i];
  }
  const Vector3 r = place(m, q), a = place(m, ahead), b = place(m, behind);
  const Vector3 spun = cross({0, 0, Real(spin)}, r);
  Real energy = 0;
  for (int i = 0; i < 3; ++i) {
    const Real v = (a[i] - b[i]) / (2 * step) + spun[i];
    energy += v * v;
  }
  Real l = Real(m.mass) / 2 * energy;
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(m.stiffness(i))) l -= Real(m.stiffness(i)) / 2 * q[6 + i] * q[6 + i];
    if (i < 2) l -= Real(m.mass) * Real(spin) * Real(spin) * Real(m.position(i)) * q[6 + i];
  }
  return l;
}

double second_derivative(const SpringMass& m, double spin, int i, int k) {
  const Real h("1e-8");
  const auto at = [&](int si, int sk) {
    State z{};
    z[static_cast<std::size_t>(i)] += si * h;
    z[static_cast<std::size_t>(k)] += sk * h;
    return lagrangian(m, spin, z);
  };
  return static_cast<double>((at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * h * h));
}

// H = K − ω²M + jωG of all nine, condensed on the hub.
HubMatrix twin(const SpringMass& m, double spin, double omega) {
  Eigen::MatrixXcd h(9, 9);
  for (int i = 0; i < 9; ++i) {
    for (int k = 0; k < 9; ++k) {
      const double stiffness = -second_derivative(m, spin, i, k);
      const double mass = second_derivative(m, spin, 9 + i, 9 + k);
      const double gyroscopic = second_derivative(m, spin, 9 + i, k) - second_derivative(m, spin, i, 9 + k);
      h(i, k) = Complex(stiffness - omega * omega * mass, omega * gyroscopic);
    }
  }
  std::vector<int> free;
  for (int i = 0; i < 3; ++i) {
    if (std::isfinite(m.stiffness(i))) free.push_back(6 + i);
  }
  const Eigen::MatrixXcd hub = h.topLeftCorner(6, 6);
  if (free.empty()) return hub;
  const std::vector<int> six{0, 1, 2, 3, 4, 5};
  const Eigen::MatrixXcd inner = h(free, free), left = h(six, free), right = h(free, six);
  return hub - left * small::solve(inner, right);
}

TEST(SpringMass, ImpedanceOfItsLagrangian) {
  const double rigid = std::numeric_limits<double>::infinity();
  const SpringMass on_axis{{0, 0, 1}, 2, {50, 40, rigid}};
  const SpringMass aside{{0.7, -0.4, 0.3}, 1.3, {30, 55, 12}};
  const SpringMass welded{{0.7, -0.4, 0.3}, 1.3, {rigid, rigid, rigid}};
  for (const SpringMass& m : {on_axis, aside, welded}) {
    for (const double omega : {0.0, 0.4, 1.7, 9.0}) {
      const double spin = 1.1;
      const HubMatrix expected = twin(m, spin, omega);
      const HubMatrix h = hub_impedance(SpringMassAppendage(m, spin), omega, spin);
      EXPECT_LE((h - expected).norm(), 1e-12 * expected.norm()) << omega << "\n" << h << "\n\n" << expected;
      EXPECT_LE((h - h.adjoint()).norm(), 1e-15 * h.norm());
    }
  }
}

// On the axis, equal springs: ω = |√(k/m) ± Ω| in plane.
TEST(SpringMass, FixedRootFrequenciesAreCounted) {
  const SpringMassAppendage m({{0, 0, 0.5}, 2, {50, 50, 8}}, 1);
  EXPECT_EQ(fixed_root_negative(m, 1.99), 0);
  EXPECT_EQ(fixed_root_negative(m, 2.01), 1);
  EXPECT_EQ(fixed_root_negative(m, 3.99), 1);
  EXPECT_EQ(fixed_root_negative(m, 4.01), 2);
  EXPECT_EQ(fixed_root_negative(m, 5.99), 2);
  EXPECT_EQ(fixed_root_negative(m, 6.01), 3);
}

}  // namespace
}  // namespace gyromode
