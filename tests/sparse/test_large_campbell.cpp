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
  for (const MeshCoordinate& c : p.coordinates) p.positions.push_back(mesh.nodes[static_cast<std::size_t>(c.node - 1)]);
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
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {1, 2, 6}, true);
  const StructureParts p = with_rest(mesh, 150, false);
  const CampbellOptions o = over(0, 500, 5, 6);
  expect_same(StructureModel(p).campbell(o), campbell(SmallStructureModel(p).spin_source(), o));
}

// Through the spins at which the first bending mode diverges and comes back with negative energy.
TEST(LargeCampbell, ThroughDivergence) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {1, 2, 6}, true);
  const StructureParts p = with_rest(mesh, 150, false);
  const CampbellOptions o = over(0, 1500, 6, 6);
  const Campbell large = StructureModel(p).campbell(o);
  expect_same(large, campbell(SmallStructureModel(p).spin_source(), o));
  for (const Encounter& e : large.encounters) EXPECT_NE(e.kind, EncounterKind::veering) << e.spin;
}

TEST(LargeCampbell, OfWhatHasNoSymmetryUnderStress) {
  bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {1, 2, 5}, true);
  for (auto& x : mesh.nodes) {  // sheared and leaning away from the axis
    x[0] += 0.2 * x[2] + 0.3 * x[1] * x[2];
    x[1] += 0.1 * x[2] * x[2];
  }
  const StructureParts p = with_rest(mesh, 100, true);
  const CampbellOptions o = over(50, 400, 5, 4);
  expect_same(StructureModel(p).campbell(o), campbell(SmallStructureModel(p).spin_source(), o));
}

TEST(LargeCampbell, SlopesAreTheSensitivityToTheSpin) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {1, 2, 6}, true);
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

// A chain between walls: |ω_k ± Ω| across the axis, ω_k along it.
TEST(LargeCampbell, OfAChainIsItsClosedForm) {
  const Index nodes = 12;
  std::vector<Eigen::Triplet<double>> mass, rest, turning;
  StructureParts p;
  p.spin = 0.3;
  const auto add = [&](Index row, Index column, double k, double softening) {
    rest.emplace_back(static_cast<int>(row), static_cast<int>(column), k);
    turning.emplace_back(static_cast<int>(row), static_cast<int>(column), k - softening);
  };
  for (Index i = 0; i < nodes; ++i) {
    for (Index d = 0; d < 3; ++d) {
      const Index at = 3 * i + d;
      mass.emplace_back(static_cast<int>(at), static_cast<int>(at), 2.0);
      add(at, at, 10, d < 2 ? 2 * p.spin * p.spin : 0);
      if (i > 0) add(at, at - 3, -5, 0);
      p.coordinates.push_back({static_cast<long>(i + 1), static_cast<int>(d)});
    }
  }
  const auto matrix = [&](const auto& entries) {
    SparseMatrix a(3 * nodes, 3 * nodes);
    a.setFromTriplets(entries.begin(), entries.end());
    return a;
  };
  p.mass = matrix(mass);
  p.stiffness = matrix(turning);
  p.stiffness_at_rest = matrix(rest);
  const Campbell c = StructureModel(p).campbell(over(0.05, 2.05, 9, 6));
  EXPECT_TRUE(c.is_complete());
  for (std::size_t s = 0; s < c.spins.size(); ++s) {
    std::vector<double> known, found;
    for (Index k = 1; k <= nodes; ++k) {
      const double along = 2 * std::sqrt(2.5) * std::sin(static_cast<double>(k) * std::acos(-1.0) / (2 * (nodes + 1)));
      for (const double w : {along, along + c.spins[s], std::abs(along - c.spins[s])}) known.push_back(w);
    }
    std::sort(known.begin(), known.end());
    for (const CampbellBranch& b : c.branches) {
      if (b.modes[s]) found.push_back(b.modes[s]->omega);
    }
    std::sort(found.begin(), found.end());
    ASSERT_GE(found.size(), 6U);
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], known[k], 1e-10 * known[k]) << c.spins[s];
  }
  for (const Encounter& e : c.encounters) EXPECT_EQ(e.kind, EncounterKind::crossing) << e.spin << " " << e.omega;
}

TEST(LargeCampbell, NeedsTheStiffnessAtRest) {
  const StructureParts p = assembled_bricks(bench::box({0.1, 0.104, 1.0}, {1, 1, 4}, true), {}, 100);
  EXPECT_THROW((void)StructureModel(p).campbell(over(0, 100, 3, 2)), NotApplicable);
  EXPECT_THROW((void)SmallStructureModel(p).campbell(over(0, 100, 3, 2)), NotApplicable);
}

}  // namespace
}  // namespace gyromode
