// Meshes with a symmetry that reverses the spin: folded into even and odd motions, against the dense engine.
#include "gyromode/base/error.h"
#include "gyromode/models/mesh_symmetry.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/windowed_motion.h"
#include "gyromode/sparse/basis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace gyromode {
namespace {

using Eigen::Vector3d;

// A truss on a grid of nx × ny × nz nodes about the axis z, nodes along edges and diagonals joined by bars, held
// softly; `shape` moves the nodes.
template <class Shape>
StructureParts truss(int nx, int ny, int nz, double spin, const Shape& shape) {
  StructureParts p;
  p.spin = spin;
  std::vector<Vector3d> at;
  std::vector<std::array<int, 3>> cell;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        at.push_back(shape(Vector3d(i - 0.5 * (nx - 1), j - 0.5 * (ny - 1), k - 0.5 * (nz - 1))));
        cell.push_back({i, j, k});
      }
    }
  }
  const auto n = static_cast<Index>(3 * at.size());
  Matrix m = Matrix::Zero(n, n), k = m;
  for (std::size_t a = 0; a < at.size(); ++a) {
    for (int d = 0; d < 3; ++d) {
      p.coordinates.push_back({static_cast<long>(a) + 1, d});
      p.positions.push_back({at[a](0), at[a](1), at[a](2)});
      const Index i = static_cast<Index>(3 * a) + d;
      m(i, i) = 1 + 0.1 * at[a].squaredNorm() / 10;
      k(i, i) += 0.5 - (d < 2 ? spin * spin * m(i, i) : 0);
    }
    for (std::size_t b = 0; b < a; ++b) {
      if (std::abs(cell[a][0] - cell[b][0]) > 1 || std::abs(cell[a][1] - cell[b][1]) > 1 || std::abs(cell[a][2] - cell[b][2]) > 1) continue;
      const Vector3d along = (at[a] - at[b]).normalized();
      const Eigen::Matrix3d bar = 5 / (at[a] - at[b]).norm() * along * along.transpose();
      const auto i = static_cast<Index>(3 * a), j = static_cast<Index>(3 * b);
      k.block<3, 3>(i, i) += bar;
      k.block<3, 3>(j, j) += bar;
      k.block<3, 3>(i, j) -= bar;
      k.block<3, 3>(j, i) -= bar;
    }
  }
  p.mass = SparseMatrix(Matrix(m.triangularView<Eigen::Lower>()).sparseView());
  p.stiffness = SparseMatrix(Matrix(k.triangularView<Eigen::Lower>()).sparseView());
  return p;
}

Matrix full(const SparseMatrix& lower, double sign) {
  const Matrix below = lower;
  Matrix all = below + sign * below.transpose();
  if (sign > 0) all.diagonal() = below.diagonal();
  return all;
}

// Modes of the folded mesh are those of the dense engine, and its shapes, in the coordinates given, are shapes.
void expect_folded(const StructureParts& p, const std::string& words) {
  const SparseMatrices given = assembled(p);
  const Matrix m = full(given.mass, 1), g = full(given.gyroscopic, -1), k = full(given.stiffness, 1);
  const ModesResult dense = find_modes(System(m, g, k));
  const SparseSystem system(in_symmetric_coordinates(p));
  ASSERT_NE(system.basis(), nullptr) << words;
  EXPECT_NE(system.basis()->in_words.find(words), std::string::npos) << system.basis()->in_words;
  ModesOptions o;
  o.lowest = 12;
  o.shapes = true;
  const ModesResult r = find_modes(system, o);
  EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
  EXPECT_EQ(r.stability, dense.stability);
  EXPECT_EQ(r.structure.system_class(), SystemClass::hidden_quadrature);
  ASSERT_GE(r.modes.size(), 12u);
  for (std::size_t i = 0; i < r.modes.size(); ++i) {
    const Mode& mode = r.modes[i];
    EXPECT_NEAR(mode.omega, dense.modes[i].omega, 1e-11 * (1 + dense.modes[i].omega)) << words << " " << i;
    EXPECT_EQ(mode.energy_sign, dense.modes[i].energy_sign);
    const ComplexVector x = mode.shape, h = k * x - mode.omega * mode.omega * (m * x) + Complex(0, mode.omega) * (g * x);
    EXPECT_LT(h.norm(), 1e-10 * k.norm() * x.norm()) << words << " " << i;
    EXPECT_NEAR(x.cwiseAbs().maxCoeff(), 1, 1e-12);
  }
}

const auto as_it_is = [](const Vector3d& p) { return p; };
// Turned about z from layer to layer: no mirror plane is left, half-turns across the axis are.
const auto twisted = [](const Vector3d& p) {
  const double angle = 0.2 * p(2);
  return Vector3d(p(0) * std::cos(angle) - p(1) * std::sin(angle), p(0) * std::sin(angle) + p(1) * std::cos(angle), p(2));
};
const auto skewed = [](const Vector3d& p) {
  return Vector3d(p(0) + 0.1 * p(1) * p(2) + 0.05 * p(1) * p(1), p(1) + 0.07 * p(2) * p(2), p(2));
};

TEST(MeshSymmetry, MirrorPlanesAlongCoordinateAxesAreFound) {
  for (const double spin : {0.2, 0.9}) expect_folded(truss(3, 4, 5, spin, as_it_is), "mirror plane with normal x");
}

// Forces and motions are in the coordinates given, whatever the mesh is folded into.
TEST(MeshSymmetry, ResponsesAreInTheCoordinatesGiven) {
  constexpr double angle = 0.4;
  const auto turned = [](const Vector3d& p) {
    return Vector3d(p(0) * std::cos(angle) - p(1) * std::sin(angle), p(0) * std::sin(angle) + p(1) * std::cos(angle), p(2));
  };
  StructureParts p = truss(3, 3, 3, 0.4, turned);
  p.symmetry = MeshSymmetry{MeshSymmetry::Kind::mirror, {std::cos(angle), std::sin(angle), 0}};
  const SparseMatrices given = assembled(p);
  const System dense(full(given.mass, 1), full(given.gyroscopic, -1), full(given.stiffness, 1));
  const SparseSystem folded(in_symmetric_coordinates(p));
  ASSERT_TRUE(folded.basis() && folded.basis()->turn);
  const Index n = dense.size();
  const Vector force = Vector::LinSpaced(n, -1, 2), grid = Vector::LinSpaced(7, 0.1, 2);
  const FrequencyResponse r = frequency_response(folded, force, grid, {}, false), expected = frequency_response(dense, force, grid, false);
  for (std::size_t i = 0; i < r.points.size(); ++i)
    EXPECT_LT((r.points[i].q - expected.points[i].q).norm(), 1e-9 * expected.points[i].q.norm()) << i;
  ModesOptions all;
  all.window.b = 100;
  const std::vector<Force> forces{{Force::Course::harmonic, force, 0.3}, {Force::Course::impulse, force, 0}};
  const State start{Vector::LinSpaced(n, 3, -1), Vector::LinSpaced(n, 1, -2)};
  const WindowedMotion motion(folded, start, forces, all, {});
  const Response truth(dense, start, forces);
  for (const double t : {0.0, 4.0}) EXPECT_LT((motion.at(t).q - truth.at(t).q).norm(), 1e-8 * truth.at(t).q.norm()) << t;
}

TEST(MeshSymmetry, HalfTurnsOfATwistedMeshAreFound) { expect_folded(truss(3, 4, 5, 0.3, twisted), "half-turn about x"); }

TEST(MeshSymmetry, OneAlongNoAxisIsToldByItsDirection) {
  constexpr double angle = 0.4;
  const auto turned = [&](const Vector3d& p) {
    return Vector3d(p(0) * std::cos(angle) - p(1) * std::sin(angle), p(0) * std::sin(angle) + p(1) * std::cos(angle), p(2));
  };
  StructureParts p = truss(3, 4, 5, 0.3, turned);
  EXPECT_EQ(SparseSystem(in_symmetric_coordinates(p)).basis(), nullptr) << "half-turns and planes are along no coordinate axis";
  p.symmetry = MeshSymmetry{MeshSymmetry::Kind::mirror, {std::cos(angle), std::sin(angle), 0}};
  expect_folded(p, "mirror plane with normal (0.921061, 0.389418, 0)");
}

// A box of equal masses: by hand.
TEST(MeshFacts, CentreAndInertia) {
  StructureParts p = truss(3, 4, 5, 0, as_it_is);
  for (Index i = 0; i < p.mass.cols(); ++i) p.mass.coeffRef(i, i) = 2;
  for (auto& at : p.positions) at[0] += 7;
  const MeshFacts f = facts_of(p);
  EXPECT_EQ(f.nodes, 60);
  ASSERT_TRUE(f.centre && f.inertia);
  EXPECT_NEAR((*f.centre)[0], 7, 1e-12);
  EXPECT_NEAR((*f.centre)[2], 0, 1e-12);
  const double xx = 2.0 / 3, yy = 15.0 / 12, zz = 2;  // mean squares of −1 … 1, −1.5 … 1.5, −2 … 2
  EXPECT_NEAR((*f.inertia)[0], 120 * (yy + zz), 1e-9);
  EXPECT_NEAR((*f.inertia)[2], 120 * (xx + yy), 1e-9);
  EXPECT_NEAR((*f.inertia)[3], 0, 1e-9);
}

TEST(MeshSymmetry, WhatIsNoneIsRefusedWithTheReason) {
  StructureParts p = truss(3, 4, 4, 0.3, skewed);
  EXPECT_EQ(in_symmetric_coordinates(p).basis, nullptr);
  const auto why = [&] {
    try {
      in_symmetric_coordinates(p);
    } catch (const LawBroken& e) {
      return std::string(e.what());
    }
    return std::string("accepted");
  };
  p.symmetry = MeshSymmetry{MeshSymmetry::Kind::mirror, {1, 0, 0}};
  EXPECT_NE(why().find("has no image"), std::string::npos) << why();
  p.symmetry->direction = {0, 0, 1};
  EXPECT_NE(why().find("must be across the axis"), std::string::npos) << why();
  p = truss(3, 4, 4, 0.3, as_it_is);
  p.symmetry = MeshSymmetry{MeshSymmetry::Kind::mirror, {1, 0, 0}};
  p.stiffness.coeffRef(1, 1) *= 1 + 1e-6;
  EXPECT_NE(why().find("K differs from its image by"), std::string::npos) << why();
  p.positions.clear();
  EXPECT_NE(why().find("needs the positions of the nodes"), std::string::npos) << why();
}

}  // namespace
}  // namespace gyromode
