// Campbell diagrams of structures by the sparse engine and a projection, against the dense engine at every spin.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/structure_model.h"
#include "meshes/bricks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gyromode {
namespace {

StructureParts with_rest(const bench::BrickMesh& mesh, double spin, bool stressed) {
  StructureParts p = assembled_bricks(mesh, {}, spin, stressed ? displacement_under_spin(mesh, {}, spin) : Vector());
  p.stiffness_at_rest = assembled_bricks(mesh, {}, 0).stiffness;
  return p;
}

CampbellOptions over(double first, double last, int count, Index lowest) {
  CampbellOptions o;
  for (int k = 0; k < count; ++k) o.spins.push_back(first + (last - first) * k / (count - 1));
  o.lowest = lowest;
  o.orders = {1, 2};
  return o;
}

// Both are of the same modes at every spin, and meet where the other does.
void expect_same(const Campbell& large, const Campbell& dense) {
  ASSERT_EQ(large.spins, dense.spins);
  EXPECT_TRUE(large.is_complete());
  EXPECT_EQ(large.stability, dense.stability);
  ASSERT_EQ(large.branches.size(), dense.branches.size());
  for (std::size_t b = 0; b < large.branches.size(); ++b) {
    for (std::size_t s = 0; s < large.spins.size(); ++s) {
      const auto &x = large.branches[b].modes[s], &y = dense.branches[b].modes[s];
      ASSERT_EQ(x.has_value(), y.has_value()) << b << " at " << large.spins[s];
      if (!x) continue;
      EXPECT_NEAR(x->omega, y->omega, 1e-9 * y->omega);
      EXPECT_EQ(x->energy_sign, y->energy_sign);
      ASSERT_TRUE(x->slope && y->slope);
      EXPECT_NEAR(*x->slope, *y->slope, 1e-5);
    }
  }
  ASSERT_EQ(large.encounters.size(), dense.encounters.size());
  for (std::size_t e = 0; e < large.encounters.size(); ++e) {
    EXPECT_EQ(large.encounters[e].kind, dense.encounters[e].kind);
    EXPECT_EQ(large.encounters[e].branches, dense.encounters[e].branches);
    EXPECT_NEAR(large.encounters[e].spin, dense.encounters[e].spin, 1e-4 * dense.spins.back());
  }
  for (std::size_t o = 0; o < large.excitation.size(); ++o) {
    const auto &x = large.excitation[o].all, &y = dense.excitation[o].all;
    ASSERT_EQ(x.size(), y.size());
    EXPECT_EQ(large.excitation[o].coverage.status, CoverageStatus::not_counted);
    for (std::size_t k = 0; k < x.size(); ++k) {
      EXPECT_NEAR(x[k].spin, y[k].spin, 1e-6 * dense.spins.back());
      EXPECT_EQ(x[k].branch, y[k].branch);
    }
  }
}

TEST(LargeCampbell, OfACantileverIsThatOfTheDenseEngine) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {2, 2, 8}, true);
  const StructureParts p = with_rest(mesh, 150, false);
  const CampbellOptions o = over(0, 500, 5, 6);
  expect_same(StructureModel(p).campbell(o), campbell(SmallStructureModel(p).spin_source(), o));
}

// Through the spins at which the first bending mode diverges and comes back with negative energy.
TEST(LargeCampbell, ThroughDivergence) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {2, 2, 8}, true);
  const StructureParts p = with_rest(mesh, 150, false);
  const CampbellOptions o = over(0, 1500, 6, 6);
  const Campbell large = StructureModel(p).campbell(o);
  expect_same(large, campbell(SmallStructureModel(p).spin_source(), o));
  for (const Encounter& e : large.encounters) EXPECT_NE(e.kind, EncounterKind::veering) << e.spin;
}

TEST(LargeCampbell, OfWhatHasNoSymmetryUnderStress) {
  const bench::BrickMesh mesh = bench::bladed_disc(2, 1, 0.3, 0.2);
  const StructureParts p = with_rest(mesh, 100, true);
  const CampbellOptions o = over(50, 400, 5, 4);
  expect_same(StructureModel(p).campbell(o), campbell(SmallStructureModel(p).spin_source(), o));
}

TEST(LargeCampbell, SlopesAreTheSensitivityToTheSpin) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {2, 2, 8}, true);
  const Model large(std::make_shared<const StructureModel>(with_rest(mesh, 150, false)));
  const Model dense(std::make_shared<const SmallStructureModel>(with_rest(mesh, 150, false)));
  ModesOptions o;
  o.lowest = 6;
  o.shapes = true;
  const auto of_large = large.sensitivities(large.modes(o).modes), of_dense = dense.sensitivities(dense.modes(o).modes);
  ASSERT_EQ(of_large.size(), 1U);
  ASSERT_EQ(of_dense.size(), 1U);
  for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(of_large[0].slope[k], of_dense[0].slope[k], 1e-6) << k;
  // By two spins, solved for themselves.
  constexpr double step = 0.1;
  const ModesResult above = large.with({{"spin", 150 + step}}).modes(o), below = large.with({{"spin", 150 - step}}).modes(o);
  for (std::size_t k = 0; k < 6; ++k)
    EXPECT_NEAR(of_large[0].slope[k], (above.modes[k].omega - below.modes[k].omega) / (2 * step), 1e-5) << k;
}

TEST(LargeCampbell, NeedsTheStiffnessAtRest) {
  const StructureParts p = assembled_bricks(bench::box({0.1, 0.104, 1.0}, {1, 1, 4}, true), {}, 100);
  EXPECT_THROW((void)StructureModel(p).campbell(over(0, 100, 3, 2)), NotApplicable);
  EXPECT_THROW((void)SmallStructureModel(p).campbell(over(0, 100, 3, 2)), NotApplicable);
}

}  // namespace
}  // namespace gyromode
