// Wire booms: Legendre functions of any degree, the impedance of one cable and of the pair of Geos against
// high-precision values (tests/cases, from a derivation that shares no code with the library), and the classical
// limits.
#include "gyromode/appendage/cable.h"
#include "gyromode/appendage/hub_impedance.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>

namespace gyromode {
namespace {

using Json = nlohmann::json;

Json cases(const std::string& name) { return Json::parse(std::ifstream(std::string(GYROMODE_SOURCE_DIR "/tests/cases/") + name)); }

double number(const Json& j) { return j.is_string() ? std::stod(j.get<std::string>()) : j.get<double>(); }

// χ = Φ′/Φ at the root.
double chi(double lambda, double z, double ratio) {
  const WireField<double> f = wire_fields(lambda, z, ratio)[1];
  return f.slope / f.value / ((1 - z) * (1 + z));
}
Index zeros(double lambda, double z, double ratio) { return wire_fields(lambda, z, ratio)[1].zeros; }

// Legendre polynomials by their recurrence: P and P′.
std::pair<double, double> polynomial(int n, double z) {
  double before = 1, now = z;
  for (int k = 1; k < n; ++k) {
    const double next = ((2 * k + 1) * z * now - k * before) / (k + 1);
    before = now;
    now = next;
  }
  return {now, n * (before - z * now) / (1 - z * z)};
}

TEST(WireField, IntegerDegreesAreLegendrePolynomials) {
  for (int n = 1; n <= 60; ++n) {
    for (const double z : {0.02, 0.1, 0.37, 0.8}) {
      const auto [value, slope] = polynomial(n, z);
      const double exact = slope / value;
      const double phase = 1e-15 * n * n * (1 + exact * exact / (n * n));  // an error of the phase δ moves χ by (ν² + χ²)δ/ν
      EXPECT_NEAR(chi(0.5 * n * (n + 1), z, 0), exact, 20 * phase) << "n = " << n << ", z = " << z;
    }
  }
}

// At the fixed-root frequencies of a wire on a hub without radius, ν = 2n − 1, a zero arrives at the root.
TEST(WireField, ZerosAreCounted) {
  for (int n = 1; n <= 40; ++n) {
    const double degree = 2 * n - 1;
    const double lambda = 0.5 * degree * (degree + 1);
    EXPECT_EQ(zeros(lambda * (1 - 1e-9), 0, 0), n - 1);
    EXPECT_EQ(zeros(lambda * (1 + 1e-9), 0, 0), n);
  }
  for (const double lambda : {-50.0, -1.0, 0.0, 0.5}) EXPECT_EQ(zeros(lambda, 0.1, 0.3), 0);
}

// A tip mass μ → 0 changes χ by O(μ ν⁴ (1 + |log μ|)): down to masses far below rounding of z itself.
TEST(WireField, VanishingTipMasses) {
  for (const double lambda : {0.3, 1.7, 20.0, -3.0}) {
    const double none = chi(lambda, 0.1, 0);
    for (const double ratio : {1e-9, 1e-14, 1e-18, 1e-30}) {
      const double bound = 40 * ratio * (1 + lambda * lambda) * (1 - std::log(ratio)) + 4e-14;
      EXPECT_NEAR(chi(lambda, 0.1, ratio), none, bound * (1 + std::abs(none))) << lambda << ", " << ratio;
    }
  }
}

// λ = 1 is the wire that stays straight, W = x/a: χ = 1/z for any tip mass; λ = 0 the one that moves rigidly.
TEST(WireField, RigidMotions) {
  for (const double ratio : {0.0, 1e-6, 0.1, 1.0, 50.0}) {
    for (const double z : {0.01, 0.2, 0.09}) {
      if (z >= 1 / std::sqrt(1 + 2 * ratio)) continue;
      EXPECT_NEAR(chi(1, z, ratio), 1 / z, 2e-14 / z) << ratio;
      EXPECT_EQ(chi(0, z, ratio), 0) << ratio;
    }
  }
}

// The pendulum of a wire hinged near the axis: Φ(z_a) = z_a − λ(⅓ + …) at λ → 0, to relative rounding of z_a itself.
TEST(WireField, RootsNearTheAxisKeepTheirDigits) {
  for (const double z : {1e-3, 1e-6, 1e-9, 1e-12}) {
    // P_ν, ν(ν + 1) = 2(1 + λ), has its zero at z_a for λ = 3z_a/2 · (1 + O(z_a)).
    const auto value = [&](double lambda) { return wire_fields(lambda, z, 0)[0].value; };
    double lo = z, hi = 2 * z;
    for (int k = 0; k < 80; ++k) (value(0.5 * (lo + hi)) * value(0.9 * z) > 0 ? lo : hi) = 0.5 * (lo + hi);
    EXPECT_NEAR(lo, 1.5 * z, 3 * z * z + 1e-15 * z) << z;
  }
}

TEST(Cable, ImpedanceOfOne) {
  for (const Json& c : cases("cable_impedance.json")) {
    const Json& d = c["cable"];
    const Cable cable{number(d["azimuth"]), number(d["radius"]),       number(d["height"]),
                      number(d["length"]),  number(d["line_density"]), number(d["tip_mass"])};
    const HubMatrix h = hub_impedance(CableGroup({cable}, number(c["spin"])), number(c["omega"]), number(c["spin"]));
    EXPECT_NEAR(number(c["spin"]) * number(c["spin"]) * cable.first_moment(), number(c["T0"]), 4e-15 * number(c["T0"]));
    for (int i = 0; i < 6; ++i) {
      for (int k = 0; k < 6; ++k) {
        const Complex exact(number(c["H_re"][i][k]), number(c["H_im"][i][k]));
        EXPECT_LE(std::abs(h(i, k) - exact), 1e-11 * std::abs(exact) + 1e-14 * h.norm()) << i << "," << k;
      }
    }
    EXPECT_LE((h - h.adjoint()).norm(), 1e-15 * h.norm());
  }
}

// Two opposite cables of Geos give the functions of the paper: f1 + m_c in the (1,1) entry and f3 + m_c in the (3,3)
// entry of an impedance with roots at the reference height.
TEST(Cable, PairOfGeosHasTheFunctionsOfThePaper) {
  const Json all = cases("spacecraft.json");
  const Json& model = all["GEOS_A"]["model"];
  const double spin = number(model["spin"]);
  Cable cable;
  cable.radius = number(model["cables"][0]["radius"]);
  cable.length = number(model["cables"][0]["length"]);
  cable.line_density = number(model["cables"][0]["line_density"]);
  cable.tip_mass = number(model["cables"][0]["tip_mass"]);
  cable.azimuth = 0.5 * std::numbers::pi;
  Cable opposite = cable;
  opposite.azimuth = -cable.azimuth;
  const CableGroup pair({cable, opposite}, spin);
  const double lumped = 2 * cable.mass();
  for (const Json& row : all["functions_of_omega"]["GEOS_A"]) {
    const double omega = number(row["w_over_Omega"]) * spin;
    const HubMatrix h = hub_impedance(pair, omega, spin);
    const double p = omega * omega + spin * spin;
    const double f1 = number(row["f1"]), g1 = number(row["g1"]), f3 = number(row["f3"]), g3 = number(row["g3"]);
    EXPECT_NEAR(-h(0, 0).real() / p, f1 + lumped, 1e-12 * (std::abs(f1) + lumped)) << omega / spin;
    EXPECT_NEAR(-h(2, 2).real() / (omega * omega), f3 + lumped, 1e-12 * (std::abs(f3) + lumped)) << omega / spin;
    EXPECT_NEAR(h(3, 3).real(), (spin * spin - omega * omega) * g1, 1e-12 * (spin * spin + omega * omega) * std::abs(g1)) << omega / spin;
    EXPECT_NEAR(h(5, 5).real(), -omega * omega * g3, 1e-11 * (spin * spin + omega * omega) * std::abs(g3)) << omega / spin;
  }
}

// The poles of a wire on a hub of small radius are near those on none: out of plane Ω√(n(2n − 1)), in plane Ω√(n(2n −
// 1) − 1).
TEST(Cable, FixedRootFrequenciesAreCounted) {
  const double spin = 0.7;
  const CableGroup c({{0.3, 1e-9, 0, 20, 0.003, 0}}, spin);
  for (int n = 2; n <= 30; ++n) {
    const double square = n * (2.0 * n - 1);
    EXPECT_EQ(fixed_root_negative(c, spin * std::sqrt(square - 1) * (1 - 1e-6)), 2 * (n - 1));
    EXPECT_EQ(fixed_root_negative(c, spin * std::sqrt(square - 1) * (1 + 1e-6)), 2 * n - 1);
    EXPECT_EQ(fixed_root_negative(c, spin * std::sqrt(square) * (1 + 1e-6)), 2 * n);
  }
}

}  // namespace
}  // namespace gyromode
