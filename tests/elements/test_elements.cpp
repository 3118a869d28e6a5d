// Rules of integration, shape functions and energies of the finite elements, against what they must integrate and
// represent exactly.
#include "gyromode/elements/elements.h"
#include "gyromode/elements/quadratic_energy.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gyromode {
namespace {

TEST(Elements, GaussRulesAreExactUpToTheirDegree) {
  for (Index points = 1; points <= 30; ++points) {
    const GaussRule rule = gauss_rule(points);
    for (Index degree = 0; degree < 2 * points; ++degree) {
      const double integral = rule.weight.dot(rule.at.array().pow(static_cast<double>(degree)).matrix());
      EXPECT_NEAR(integral, 1.0 / static_cast<double>(degree + 1), 1e-14) << points << " points, x^" << degree;
    }
  }
}

TEST(Elements, LagrangeShapesRepresentPolynomials) {
  for (Index degree = 1; degree <= 24; ++degree) {
    const LagrangeElement element(degree);
    for (const LagrangePoint& p : element.points()) {
      EXPECT_NEAR(p.shape.sum(), 1, 1e-13);
      EXPECT_NEAR(p.slope.sum(), 0, 1e-10);
      EXPECT_LE((p.shape - lagrange_shape(degree, p.at)).norm(), 1e-13);
    }
    EXPECT_NEAR(lagrange_shape(degree, 0)(0), 1, 1e-14);
    EXPECT_NEAR(lagrange_shape(degree, 1)(degree), 1, 1e-14);
  }
}

// A cubic through its values and slopes at both ends; its curvature.
TEST(Elements, HermiteShapesRepresentCubics) {
  for (const double h : {1e-3, 1.0, 250.0}) {
    const auto cubic = [&](double x) { return 1 - 2 * x + 3 * x * x - 0.5 * x * x * x; };  // of x = position / h
    const Eigen::Vector4d ends{cubic(0), -2 / h, cubic(1), (-2 + 6 - 1.5) / h};
    for (const HermitePoint& p : hermite_points(h)) {
      EXPECT_NEAR(p.shape.dot(ends), cubic(p.at), 1e-14);
      EXPECT_NEAR(p.curvature.dot(ends) * h * h, 6 - 3 * p.at, 1e-12);
      EXPECT_LE((p.shape - hermite_shape(h, p.at)).norm(), 1e-13 * std::max(1.0, h));
    }
  }
}

// A free mass point at p in turning axes: M = m, G = 2mΩ[0 −1; 1 0], K = −mΩ² across the axis, nothing along it.
TEST(Elements, EnergyOfAFreePoint) {
  constexpr double m = 2.5, spin = 3;
  QuadraticEnergy e(6, spin);
  e.add_point(m, Eigen::Vector3d::Zero());
  const Matrix mass = e.mass().topLeftCorner(3, 3), g = e.gyroscopic().topLeftCorner(3, 3), k = e.stiffness().topLeftCorner(3, 3);
  EXPECT_LE((mass - m * Matrix::Identity(3, 3)).norm(), 1e-15);
  EXPECT_LE((g - 2 * m * spin * Matrix{{0, -1, 0}, {1, 0, 0}, {0, 0, 0}}).norm(), 1e-14);
  EXPECT_LE((k + m * spin * spin * Matrix{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}).norm(), 1e-14);
  EXPECT_LE(e.mass().bottomRightCorner(3, 3).norm() + e.stiffness().bottomRightCorner(3, 3).norm(), 1e-15);
}

// Points of a body: its rotation about axis 1 and 2 is Euler's, (I₃ − I₂)Ω² and (I₃ − I₁)Ω² on the diagonal of K, (I₁ +
// I₂ − I₃)Ω in G.
TEST(Elements, EnergyOfARigidBodyIsEulers) {
  constexpr double spin = 1.7;
  QuadraticEnergy e(6, spin);
  double i[3] = {0, 0, 0};
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 0.5, 0), Eigen::Vector3d(0, 0, 2)}) {
    for (const double side : {-1.0, 1.0}) e.add_point(3, side * p);
    for (int axis = 0; axis < 3; ++axis) i[axis] += 2 * 3 * (p.squaredNorm() - p(axis) * p(axis));
  }
  const Matrix m = e.mass().bottomRightCorner(3, 3), g = e.gyroscopic().bottomRightCorner(3, 3), k = e.stiffness().bottomRightCorner(3, 3);
  EXPECT_LE((m - Matrix(Vector{{i[0], i[1], i[2]}}.asDiagonal())).norm(), 1e-13);
  EXPECT_NEAR(std::abs(g(0, 1)), std::abs(i[0] + i[1] - i[2]) * spin, 1e-12);
  EXPECT_NEAR(k(0, 0), (i[2] - i[1]) * spin * spin, 1e-12);
  EXPECT_NEAR(k(1, 1), (i[2] - i[0]) * spin * spin, 1e-12);
  EXPECT_NEAR(k(2, 2), 0, 1e-13);
}

}  // namespace
}  // namespace gyromode
