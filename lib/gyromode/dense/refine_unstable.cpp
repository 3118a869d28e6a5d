#include "gyromode/dense/refine_unstable.h"

#include <Eigen/LU>

#include <cmath>
#include <limits>

namespace gyromode::dense {

namespace {

struct NullPair {
  ComplexVector right, left;
};

// Two steps of inverse iteration on both sides, from a fixed start that no structure makes orthogonal to a null vector.
NullPair null_vectors(const ComplexMatrix& n) {
  const Eigen::PartialPivLU<ComplexMatrix> lu(n);
  ComplexVector start(n.rows());
  for (Index i = 0; i < n.rows(); ++i) start(i) = std::polar(1.0, 0.7 + 1.9 * static_cast<double>(i * i % 97));
  NullPair v{start, start};
  for (int step = 0; step < 2; ++step) {
    v.right = lu.solve(v.right);
    v.left = lu.adjoint().solve(v.left);
    v.right.normalize();
    v.left.normalize();
  }
  return v;
}

}  // namespace

UnstableRoot refine_unstable(const Impedance& h, Complex lambda, double reach) {
  constexpr int most_steps = 8;
  const double epsilon = std::numeric_limits<double>::epsilon();
  const bool real = lambda.imag() == 0;
  const Complex start = lambda;
  UnstableRoot first{start, ComplexVector::Zero(h.size()), std::numeric_limits<double>::infinity()};
  for (int step = 0; step < most_steps; ++step) {
    const ComplexMatrix n = h.characteristic_at(lambda);
    const NullPair v = null_vectors(n);
    if (!v.right.allFinite() || !v.left.allFinite()) {  // singular to the last bit
      lambda *= 1 + 4 * epsilon;
      continue;
    }
    const Complex slope = v.left.dot(h.characteristic_slope_at(lambda) * v.right);
    UnstableRoot here{lambda, v.right, h.scale(std::abs(lambda)) / std::abs(slope)};
    if (first.shape.isZero(0)) first = here;
    Complex change = -v.left.dot(n * v.right) / slope;
    if (real) change = change.real();
    if (std::abs(change) <= 4 * epsilon * (std::abs(lambda) + here.sensitivity)) return here;
    if (!(std::abs(lambda + change - start) <= reach)) break;
    lambda += change;
  }
  return {start, first.shape, first.sensitivity};
}

}  // namespace gyromode::dense
