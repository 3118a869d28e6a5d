#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// A point of integration in an element [0, 1]: where, weight, shape functions and slopes by the coordinate of the
/// element.
struct LagrangePoint {
  double at, weight;
  Vector shape, slope;
};

/// An element of polynomials through degree + 1 Gauss–Lobatto nodes, integrated by Gauss's rule of degree + 2 points
/// (exact for mass and quadratic tension).
class LagrangeElement {
 public:
  explicit LagrangeElement(Index degree);
  const std::vector<LagrangePoint>& points() const { return points_; }

 private:
  std::vector<LagrangePoint> points_;
};

/// Shape functions of an element of that degree at x in [0, 1].
Vector lagrange_shape(Index degree, double x);
/// Shape functions of a cubic element of length h at x in [0, 1].
Eigen::Vector4d hermite_shape(double h, double x);

/// A cubic beam element of length h at the four points of Gauss's rule: shape and curvature of (displacement, slope) at
/// both ends.
struct HermitePoint {
  double at, weight;
  Eigen::Vector4d shape, curvature;
};
std::vector<HermitePoint> hermite_points(double h);

/// Gauss's rule on [0, 1]: nodes and weights by the eigenvalues of the Jacobi matrix of Legendre's polynomials (Golub &
/// Welsch 1969).
struct GaussRule {
  Vector at, weight;
};
GaussRule gauss_rule(Index points);

}  // namespace gyromode
