// Axial booms: cantilever functions against high-precision values (tests/cases), the decoupling against the whirl form
// of an axisymmetric boom, rigid limits and counts.
#include "gyromode/appendage/beam.h"
#include "gyromode/appendage/bernoulli.h"
#include "gyromode/appendage/hub_impedance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <string>

namespace gyromode {
namespace {

using Json = nlohmann::json;

double number(const Json& j) { return std::stod(j.get<std::string>()); }

// Dynamic stiffness of the root from the answer to loads: d = −κM − κ²C, M of the rigid beam.
Eigen::Matrix2d cantilever_stiffness(double kappa, double l, double e) {
  const FieldResponse<double> a = cantilever_answer(kappa, l, e);
  Eigen::Matrix2d rigid, c;
  rigid << l + e, 0.5 * l * l + e * l, 0, l * l * l / 3 + e * l * l;
  rigid(1, 0) = rigid(0, 1);
  c << a.q11 / a.phi - a.lump11, a.q12 / a.phi - a.lump12, a.q12 / a.phi - a.lump12, a.q22 / a.phi - a.lump22;
  EXPECT_NEAR(a.q11 * a.q22 - a.q12 * a.q12, a.phi * a.det, 1e-13 * std::abs(a.q11 * a.q22) + 1e-13 * a.q12 * a.q12);
  return -kappa * rigid - kappa * kappa * c;
}

TEST(Cantilever, StiffnessOfUnitLength) {
  const Json all = Json::parse(std::ifstream(GYROMODE_SOURCE_DIR "/tests/cases/spacecraft.json"));
  for (const Json& c : all["beam_unit_l1_EI1"]) {
    const Eigen::Matrix2d d = cantilever_stiffness(number(c["kappa_l4"]), 1, number(c["eps_over_l"]));
    EXPECT_NEAR(d(0, 0), number(c["d11"]), 1e-13 * std::abs(number(c["d11"])));
    EXPECT_NEAR(d(0, 1), number(c["d12"]), 1e-13 * std::abs(number(c["d12"])));
    EXPECT_NEAR(d(1, 0), d(0, 1), 1e-14 * std::abs(d(0, 1)));
    EXPECT_NEAR(d(1, 1), number(c["d22"]), 1e-13 * std::abs(number(c["d22"])));
  }
}

TEST(Cantilever, SeriesAndClosedFormMeet) {
  for (const double tip : {0.0, 0.2, 3.0}) {
    const Eigen::Matrix2d below = cantilever_stiffness(std::pow(2 - 1e-13, 4), 1, tip);
    const Eigen::Matrix2d above = cantilever_stiffness(std::pow(2 + 1e-13, 4), 1, tip);
    EXPECT_LE((below - above).norm(), 1e-11 * below.norm()) << tip;
  }
}

// cos b cosh b = −1: b = 1.8751040687119611, 4.6940911329741746, 7.8547574382376126, then (n − 1/2)π to the last digit.
TEST(Cantilever, FrequenciesAreCounted) {
  const auto below = [](double kappa) { return cantilever_poles_below(kappa, 1, cantilever_answer(kappa, 1, 0).phi); };
  const double first[] = {1.8751040687119611, 4.6940911329741746, 7.8547574382376126};
  for (int n = 1; n <= 300; ++n) {
    const double b = n <= 3 ? first[n - 1] : n < 12 ? 0 : (n - 0.5) * 3.14159265358979323846;
    if (b == 0) continue;
    EXPECT_EQ(below(std::pow(b * (1 - 1e-10), 4)), n - 1);
    EXPECT_EQ(below(std::pow(b * (1 + 1e-10), 4)), n);
  }
  EXPECT_TRUE(cantilever_stiffness(1e20, 1, 0.1).allFinite()) << "no overflow";
}

// A boom that cannot bend is a rod: −ω²M + jωG + K of its mass, first moment and inertia about O.
TEST(Beam, StiffBoomIsARigidRod) {
  for (const bool upward : {true, false}) {
    const Beam beam{0.4, upward, 3, 0.2, {1e13, 3e13}, 0.5};
    const double spin = 0.7, omega = 1.9;
    const double l = beam.length, up = upward ? 1 : -1;
    const double mass = beam.mass();
    const double along = 0.5 * beam.line_density * l * l + beam.tip_mass * l;
    const double along2 = beam.line_density * l * l * l / 3 + beam.tip_mass * l * l;
    const double moment = mass * beam.root_height + up * along;
    const double inertia = mass * beam.root_height * beam.root_height + 2 * up * beam.root_height * along + along2;
    const double p = omega * omega + spin * spin, t = 2 * omega * spin;
    // (X, Y) = (ζ1 + zθ2, ζ2 − zθ1) of every mass, −[[p, jt], [−jt, p]] on them.
    Eigen::Matrix<Complex, 6, 6> expected = Eigen::Matrix<Complex, 6, 6>::Zero();
    const Complex j(0, 1);
    const auto put = [&](int row, int column, Complex value) {
      expected(row, column) = value;
      expected(column, row) = std::conj(value);
    };
    put(0, 0, -p * mass);
    put(1, 1, -p * mass);
    put(0, 1, -j * t * mass);
    put(0, 4, -p * moment);
    put(1, 3, p * moment);
    put(0, 3, j * t * moment);
    put(1, 4, j * t * moment);
    put(3, 3, -p * inertia);
    put(4, 4, -p * inertia);
    put(3, 4, -j * t * inertia);
    put(2, 2, -omega * omega * mass);
    const HubMatrix h = hub_impedance(BeamAppendage(beam, spin), omega, spin);
    EXPECT_LE((h - expected).norm(), 1e-10 * expected.norm()) << (upward ? "up" : "down");
  }
}

// Axisymmetric: seen from axes at rest the boom whirls at ω ± Ω; Σ and A are half the sum and difference of its
// stiffness there.
TEST(Beam, AxisymmetricBoomWhirls) {
  const double stiffness = 20, density = 0.06, l = 7.5, tip = 0.05, spin = 0.52;
  const Beam beam{0, true, l, density, {stiffness, stiffness}, tip};
  for (const double omega : {0.0, 0.1, 0.52, 1.3, 20.0}) {
    const auto at_rest = [&](double w) {
      return Eigen::Matrix2d(stiffness * cantilever_stiffness(density * w * w / stiffness, l, tip / density));
    };
    const Eigen::Matrix2d sum = 0.5 * (at_rest(omega + spin) + at_rest(omega - spin));
    const Eigen::Matrix2d difference = 0.5 * (at_rest(omega + spin) - at_rest(omega - spin));
    const HubMatrix h = hub_impedance(BeamAppendage(beam, spin), omega, spin);
    const double size = h.norm();
    EXPECT_NEAR(h(0, 0).real(), sum(0, 0), 1e-12 * size) << omega;
    EXPECT_NEAR(h(0, 4).real(), sum(0, 1), 1e-12 * size) << omega;
    EXPECT_NEAR(h(4, 4).real(), sum(1, 1), 1e-12 * size) << omega;
    EXPECT_NEAR(h(0, 1).imag(), difference(0, 0), 1e-12 * size) << omega;
    EXPECT_LE((h - h.adjoint()).norm(), 1e-15 * size);
  }
}

}  // namespace
}  // namespace gyromode
