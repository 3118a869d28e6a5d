// Bodies that nothing holds, in axes that turn with them, under the stress of their spin.
#include "gyromode/models/mesh_symmetry.h"
#include "gyromode/models/structure_mesh.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/sparse/matrix.h"
#include "meshes/bricks.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace gyromode {
namespace {

// A box of steel, 0.3 × 0.32 × 1 m, about the axis along its length or, where it is `flat`, 1 × 0.9 × 0.2; `lean` moves
// its nodes, so that no symmetry is left.
StructureParts free_box(double spin, bool flat, double lean) {
  using namespace bench;
  BrickMesh mesh = flat ? box({1, 0.9, 0.2}, {4, 4, 1}, false) : box({0.3, 0.32, 1}, {2, 2, 4}, false);
  for (auto& at : mesh.nodes) {
    const double x = at[0];
    at[0] += lean * at[1] * at[2];
    at[2] += lean * x * at[1];
  }
  // The axis goes through the centre of mass: else it would not turn about it freely.
  StructureParts still = assembled_bricks(mesh, {}, 0);
  const auto place = [&](StructureParts& p) {
    for (const MeshCoordinate& c : p.coordinates) p.positions.push_back(mesh.nodes[static_cast<std::size_t>(c.node - 1)]);
  };
  place(still);
  const auto centre = *facts_of(still).centre;
  for (auto& at : mesh.nodes) {
    for (std::size_t d = 0; d < 3; ++d) at[d] -= centre[d];
  }
  StructureParts p = assembled_bricks(mesh, {}, spin, displacement_under_spin(mesh, {}, spin));
  place(p);
  return p;
}

// The dense engine on what is left without the free motions: C spans what is M-orthogonal to translations T and to the
// motions N along and about the axis, whose momenta NᵀM(Nȧ) + NᵀGCċ vanish (Routh):
//     CᵀMC c̈ + CᵀGC ċ + (CᵀKC + AᵀM₀⁻¹A) c = 0,  A = NᵀGC,  M₀ = NᵀMN.
ModesResult dense_without_free(const SparseMatrices& s) {
  const Matrix m = sparse::full(s.mass, 1), g = sparse::full(s.gyroscopic, -1), k = sparse::full(s.stiffness, 1);
  Matrix free(m.rows(), 4);
  free << s.translations, s.rigid;
  const Matrix c = Matrix(Eigen::HouseholderQR<Matrix>(m * free).householderQ()).rightCols(m.cols() - 4);
  const auto in = [&](const Matrix& a, double sign) {
    const Matrix b = c.transpose() * a * c;
    return Matrix(0.5 * (b + sign * b.transpose()));
  };
  const Matrix a = s.rigid.transpose() * g * c, m0 = s.rigid.transpose() * m * s.rigid, more = a.transpose() * m0.inverse() * a;
  return find_modes(System(in(m, 1), in(g, -1), in(k, 1) + 0.5 * (more + more.transpose())));
}

void expect_free(double spin, bool flat, double lean) {
  const std::string which = (flat ? "flat " : "long ") + std::to_string(spin) + " " + std::to_string(lean);
  const StructureParts p = free_box(spin, flat, lean);
  const SparseMatrices given = assembled(p);
  ASSERT_EQ(given.translations.cols(), 2) << which;
  ASSERT_EQ(given.rigid.cols(), 2) << which;
  const ModesResult dense = dense_without_free(given);
  ModesOptions o;
  o.lowest = 12;
  const ModesResult r = find_modes(SparseSystem(in_symmetric_coordinates(p)), o);
  EXPECT_TRUE(r.is_complete()) << which << ": " << r.coverage.reason;
  EXPECT_EQ(r.index_balance.zero, 2) << which;
  ASSERT_GE(r.modes.size(), 14u) << which;
  bool tilt = false;
  for (std::size_t i = 0; i < r.modes.size(); ++i) {
    EXPECT_EQ(r.modes[i].kind == ModeKind::rigid_body, i < 2) << which << " " << i;
    EXPECT_LT(r.modes[i].residual, 1e-10) << which;
    if (i < 2) continue;
    EXPECT_NEAR(r.modes[i].omega, dense.modes[i - 2].omega, 1e-9 * dense.modes[i - 2].omega + dense.modes[i - 2].error_bound)
        << which << " " << i;
    EXPECT_EQ(r.modes[i].energy_sign, dense.modes[i - 2].energy_sign) << which << " " << i;
    tilt = tilt || std::abs(r.modes[i].omega - spin) <= 1e-9 * spin;
  }
  EXPECT_TRUE(tilt) << which << ": the momentum axis stands still, which is a motion at the spin";
  const bool negative = std::any_of(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.energy_sign < 0; });
  EXPECT_EQ(r.stability, negative ? Stability::gyroscopically_stabilised : Stability::stable) << which;
}

TEST(FreeBody, IsAsTheDenseEngineHasItWithoutTranslation) {
  for (const double spin : {100.0, 1000.0, 6000.0}) {
    for (const bool flat : {false, true}) {
      for (const double lean : {0.0, 0.1}) expect_free(spin, flat, lean);
    }
  }
}

// A body that nothing holds is driven without a bound at rest and at its spin, and solved for elsewhere.
TEST(FreeBody, FrequencyResponse) {
  constexpr double spin = 1000;
  const StructureParts p = free_box(spin, false, 0.1);
  const SparseMatrices given = assembled(p);
  const Matrix m = sparse::full(given.mass, 1), g = sparse::full(given.gyroscopic, -1), k = sparse::full(given.stiffness, 1);
  Vector force = Vector::Zero(m.rows()), grid(4);
  force(7) = 1;  // across the axis, at a distance from it: it turns the body too
  grid << 0, 0.5 * spin, spin, 1.5 * spin;
  const FrequencyResponse r = frequency_response(SparseSystem(in_symmetric_coordinates(p)), force, grid, {}, false);
  ASSERT_EQ(r.points.size(), 4u);
  EXPECT_TRUE(r.points[0].resonance());
  EXPECT_TRUE(r.points[2].resonance());
  for (const std::size_t i : {1u, 3u}) {
    const double w = grid(static_cast<Index>(i));
    const ComplexMatrix h = (k - w * w * m).cast<Complex>() + Complex(0, w) * g;
    const ComplexVector q = h.partialPivLu().solve(force.cast<Complex>());
    EXPECT_LT((r.points[i].q - q).norm(), 1e-7 * q.norm()) << w;
  }
}

}  // namespace
}  // namespace gyromode
