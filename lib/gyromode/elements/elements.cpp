#include "gyromode/elements/elements.h"

#include "gyromode/lapack/small.h"

#include <cmath>

namespace gyromode {

namespace {

// Golub & Welsch: nodes from the Jacobi matrix with off-diagonals b_k, weights from the first components of its
// vectors.
GaussRule from_jacobi(const Vector& off_diagonal) {
  const Index n = off_diagonal.size() + 1;
  Matrix jacobi = Matrix::Zero(n, n);
  jacobi.diagonal(1) = off_diagonal;
  jacobi.diagonal(-1) = off_diagonal;
  const auto e = small::symmetric_eigen(jacobi);
  return {(0.5 * (e.values.array() + 1)).matrix(), e.vectors.row(0).cwiseAbs2().transpose()};
}

double legendre_off_diagonal(Index k) { return static_cast<double>(k) / std::sqrt(4.0 * static_cast<double>(k * k) - 1); }

// Gauss–Lobatto nodes on [0, 1]: the ends and the Gauss nodes of the weight x(1 − x) (Jacobi polynomials α = β = 1).
Vector lobatto_nodes(Index degree) {
  Vector nodes(degree + 1);
  nodes(0) = 0;
  nodes(degree) = 1;
  if (degree == 1) return nodes;
  Vector off(std::max<Index>(degree - 2, 0));
  for (Index k = 1; k <= off.size(); ++k) {
    const double n = static_cast<double>(k);
    off(k - 1) = std::sqrt(n * (n + 2) / ((2 * n + 1) * (2 * n + 3)));
  }
  nodes.segment(1, degree - 1) = from_jacobi(off).at;
  return nodes;
}

}  // namespace

GaussRule gauss_rule(Index points) {
  Vector off(points - 1);
  for (Index k = 1; k < points; ++k) off(k - 1) = legendre_off_diagonal(k);
  return from_jacobi(off);
}

LagrangeElement::LagrangeElement(Index degree) {
  const Vector nodes = lobatto_nodes(degree);
  const GaussRule rule = gauss_rule(degree + 2);
  for (Index g = 0; g < rule.at.size(); ++g) {
    const double x = rule.at(g);
    LagrangePoint p{x, rule.weight(g), Vector::Ones(degree + 1), Vector::Zero(degree + 1)};
    for (Index i = 0; i <= degree; ++i) {
      for (Index k = 0; k <= degree; ++k) {
        if (k == i) continue;
        double product = 1 / (nodes(i) - nodes(k));
        p.shape(i) *= (x - nodes(k)) * product;
        for (Index l = 0; l <= degree; ++l) {
          if (l != i && l != k) product *= (x - nodes(l)) / (nodes(i) - nodes(l));
        }
        p.slope(i) += product;
      }
    }
    points_.push_back(std::move(p));
  }
}

Vector lagrange_shape(Index degree, double x) {
  const Vector nodes = lobatto_nodes(degree);
  Vector shape = Vector::Ones(degree + 1);
  for (Index i = 0; i <= degree; ++i) {
    for (Index k = 0; k <= degree; ++k) {
      if (k != i) shape(i) *= (x - nodes(k)) / (nodes(i) - nodes(k));
    }
  }
  return shape;
}

Eigen::Vector4d hermite_shape(double h, double x) {
  return {1 - 3 * x * x + 2 * x * x * x, h * (x - 2 * x * x + x * x * x), 3 * x * x - 2 * x * x * x, h * (x * x * x - x * x)};
}

std::vector<HermitePoint> hermite_points(double h) {
  const GaussRule rule = gauss_rule(4);
  std::vector<HermitePoint> points;
  for (Index g = 0; g < 4; ++g) {
    const double x = rule.at(g);
    HermitePoint p{x, rule.weight(g), {}, {}};
    p.shape = hermite_shape(h, x);
    p.curvature << (12 * x - 6) / (h * h), (6 * x - 4) / h, (6 - 12 * x) / (h * h), (6 * x - 2) / h;
    points.push_back(p);
  }
  return points;
}

}  // namespace gyromode
