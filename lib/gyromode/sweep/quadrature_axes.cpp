#include "gyromode/sweep/quadrature_axes.h"

#include <algorithm>

namespace gyromode {

QuadratureAxes::QuadratureAxes(const std::vector<Index>& coordinates, const std::vector<Index>& in_quadrature) {
  for (const Index c : coordinates) quadrature_.push_back(std::binary_search(in_quadrature.begin(), in_quadrature.end(), c));
}

// t̄_a (j g_ab) t_b with t = 1 or −j, one of each: g_ab where b is in quadrature, else −g_ab.
Matrix QuadratureAxes::crossed(const Matrix& g) const {
  Matrix b = g;
  for (Index col = 0; col < g.cols(); ++col) {
    if (!quadrature(col)) b.col(col) *= -1;
  }
  return b;
}

ComplexMatrix QuadratureAxes::times(ComplexMatrix x, const Complex& factor) const {
  for (Index i = 0; i < x.rows(); ++i) {
    if (quadrature(i)) x.row(i) *= factor;
  }
  return x;
}

}  // namespace gyromode
