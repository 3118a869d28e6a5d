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

UnstableRoot refine_unstable(const Impedance& h, Complex lambda) {
  constexpr int most_steps = 6;
  const double epsilon = std::numeric_limits<double>::epsilon();
  const bool real = lambda.imag() == 0;
  const Complex start = lambda;
  UnstableRoot root{lambda, ComplexVector::Zero(h.size()), std::numeric_limits<double>::infinity()};
  for (int step = 0; step < most_steps; ++step) {
    ComplexMatrix n = h.characteristic_at(lambda);
    NullPair v = null_vectors(n);
    if (!v.right.allFinite() || !v.left.allFinite()) {  // singular to the last bit
      lambda *= 1 + 4 * epsilon;
      continue;
    }
    const Complex slope = v.left.dot(h.characteristic_slope_at(lambda) * v.right);
    Complex change = -v.left.dot(n * v.right) / slope;
    if (real) change = change.real();
    if (!(std::abs(lambda + change - start) <= 0.1 * std::abs(start))) break;
    lambda += change;
    root = {lambda, v.right, h.scale(std::abs(lambda)) / std::abs(slope)};
    if (std::abs(change) <= 2 * epsilon * std::abs(lambda)) break;
  }
  return root;
}

}  // namespace gyromode::dense
