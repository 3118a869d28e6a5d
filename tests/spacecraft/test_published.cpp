// Geos and ISPM against 34-digit values (tests/cases/spacecraft.json, from a derivation that shares no code with the
// library): frequencies, matrices, counts.
#include "gyromode/appendage/wire_field.h"
#include "gyromode/roots/certified_roots.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"
#include "gyromode/structure/realify.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <numbers>

namespace gyromode {
namespace {

using Json = nlohmann::json;

const Json& cases() {
  static const Json all = Json::parse(std::ifstream(GYROMODE_SOURCE_DIR "/tests/cases/spacecraft.json"));
  return all;
}

double number(const Json& j) { return j.is_string() ? std::stod(j.get<std::string>()) : j.get<double>(); }

Spacecraft satellite(const Json& model) {
  Eigen::Vector3d inertia;
  for (Index i = 0; i < 3; ++i) inertia(i) = number(model["body"]["inertia"][static_cast<std::size_t>(i)]);
  std::vector<Cable> cables;
  for (const Json& c : model["cables"]) {
    cables.push_back({number(c["azimuth_deg"]) * std::numbers::pi / 180, number(c["radius"]), number(c["height"]), number(c["length"]),
                      number(c["line_density"]), number(c["tip_mass"])});
  }
  std::vector<Beam> beams;
  if (model.contains("beam")) {
    const Json& b = model["beam"];
    beams.push_back({number(b["root"][2]),
                     number(b["direction"][2]) > 0,
                     number(b["length"]),
                     number(b["line_density"]),
                     {number(b["EI_for_motion_along_axis_1"]), number(b["EI_for_motion_along_axis_2"])},
                     number(b["tip_mass"])});
  }
  return Spacecraft(number(model["spin"]), {number(model["body"]["mass"]), inertia.asDiagonal()}, cables, beams);
}

// The roots of the block that holds coordinate `of` of the body, below `below` spins, over the spin.
std::vector<double> roots_of_class(const Spacecraft& s, Index of, double below) {
  const SpacecraftImpedance impedance(s);
  const CertifiedRoots roots(impedance, SpacecraftImpedance::free_coordinates(), SpacecraftImpedance::cyclic_coordinates(), 0,
                             [](Index) { return std::nullopt; });
  EXPECT_TRUE(roots.closed());
  std::vector<double> found;
  for (const Root& r : roots.between(0, below).roots) {
    const auto& c = roots.blocked().blocks[static_cast<std::size_t>(r.block)].coordinates;
    if (std::find(c.begin(), c.end(), of) != c.end()) found.push_back(r.omega);
  }
  return found;
}

constexpr Index zeta3 = 2, theta1 = 3, theta3 = 5;

TEST(Geos, NutationAndCablesToSixteenDigits) {
  const Json& c = cases()["GEOS_A"];
  const Spacecraft s = satellite(c["model"]);
  const std::vector<double> found = roots_of_class(s, theta1, 7);
  ASSERT_EQ(static_cast<int>(found.size()), c["class_i_count_below_7_spin"].get<int>());
  for (std::size_t i = 0; i < c["class_i_omega_rad_s"].size(); ++i) {
    const double exact = number(c["class_i_omega_rad_s"][i]);
    EXPECT_NEAR(found[i] * s.spin(), exact, 1e-14 * exact) << i;
  }
}

TEST(Geos, OtherClassesToAllPrintedDigits) {
  const Json& c = cases()["GEOS_A"];
  const Spacecraft s = satellite(c["model"]);
  for (const auto& [coordinate, key] :
       {std::pair(theta3, "theta3_class_omega_over_spin"), std::pair(zeta3, "zeta3_class_omega_over_spin")}) {
    const std::vector<double> found = roots_of_class(s, coordinate, 6);
    ASSERT_GE(found.size() + 1, c[key].size());
    for (std::size_t i = 1; i < c[key].size(); ++i) {  // the first is the rigid-body mode, 0
      const double printed = number(c[key][i]);
      EXPECT_NEAR(found[i - 1], printed, printed < 1 ? 5.1e-10 : 5.1e-9) << key << i;
    }
  }
}

TEST(Geos, CountsBelowTwentyThirtyAndFortySpins) {
  const Json& c = cases()["GEOS_A"];
  const Spacecraft s = satellite(c["model"]);
  for (const int spins : {20, 30, 40}) {
    const auto found = roots_of_class(s, theta1, spins);
    EXPECT_EQ(static_cast<int>(found.size()), c["class_i_count_below"][std::to_string(spins) + "_spin"].get<int>());
    ModesOptions options;
    options.window.b = spins * s.spin();
    const ModesResult all = find_modes(s, options);
    EXPECT_EQ(all.coverage.status, CoverageStatus::complete);
    EXPECT_EQ(all.stability, Stability::stable);
    const CountResult count = count_modes(s, options.window);
    EXPECT_EQ(count.count, all.coverage.found);
  }
}

TEST(Ispm, NutationCablesAndBoomToSixteenDigits) {
  const Json& c = cases()["ISPM_A_axisym"];
  const Spacecraft s = satellite(c["model"]);
  const std::vector<double> found = roots_of_class(s, theta1, 7);
  ASSERT_EQ(static_cast<int>(found.size()), c["class_i_count_below_7_spin"].get<int>());
  for (std::size_t i = 0; i < c["class_i_omega_rad_s"].size(); ++i) {
    const double exact = number(c["class_i_omega_rad_s"][i]);
    EXPECT_NEAR(found[i] * s.spin(), exact, 2e-14 * exact) << i;
  }
}

// The matrix of the paper, real symmetric in (ζ1, θ2, jζ2, jθ1), about the mass centre of the complete satellite.
TEST(Geos, MatrixEntries) {
  const Json& c = cases()["GEOS_A"];
  const Spacecraft s = satellite(c["model"]);
  EXPECT_NEAR(s.rigid().mass, number(c["paper_variables"]["mtot"]), 1e-12 * s.rigid().mass);
  EXPECT_NEAR(-s.centre(), number(c["derived"]["z_hub"]), 1e-12);
  const Structure structure = analyse(s);
  const Index order[] = {0, 4, 1, 3};
  for (const Json& row : cases()["functions_of_omega"]["GEOS_A"]) {
    const double omega = number(row["w_over_Omega"]) * s.spin();
    const Realified t = realify(impedance_at(s, omega), structure);
    std::size_t at = 0;
    double largest = 0;
    for (const Json& entry : row["Hstar_upper_order_z1_t2_jz2_jt1"]) largest = std::max(largest, std::abs(number(entry)));
    for (int i = 0; i < 4; ++i) {
      for (int k = i; k < 4; ++k, ++at) {
        // q* = (ζ1, θ2, jζ2, jθ1): H* = T⁻¹HT with T = diag(1, −j), as here.
        const double exact = number(row["Hstar_upper_order_z1_t2_jz2_jt1"][at]);
        EXPECT_NEAR(t.real_symmetric(order[i], order[k]), exact, 1e-11 * std::abs(exact) + 1e-14 * largest)
            << omega / s.spin() << ": " << i << "," << k;
      }
    }
    EXPECT_LE((t.unitary.adjoint() * t.impedance * t.unitary - t.real_symmetric.cast<Complex>()).norm(), 1e-14 * t.impedance.norm());
  }
}

// P_ν along the wire, ν not whole.
TEST(WireShape, LegendreFunctions) {
  for (const Json& row : cases()["legendre_P"]) {
    const double nu = number(row["nu"]), z = number(row["z"]), exact = number(row["P"]);
    EXPECT_NEAR(wire_shape(0.5 * nu * (nu + 1), {0.9999, z}, 0).back(), exact, 2e-15 * (1 + nu)) << nu << ", " << z;
  }
}

}  // namespace
}  // namespace gyromode
