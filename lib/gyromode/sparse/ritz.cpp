#include "gyromode/sparse/ritz.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/solve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::sparse {

// One component, with the partition that the columns have.
RitzPairs ritz_pairs(const Subspace& v) {
  const Index p = v.size();
  Component c;
  c.coordinates.resize(static_cast<std::size_t>(p));
  std::iota(c.coordinates.begin(), c.coordinates.end(), Index{0});
  const bool partition = std::find(v.across().begin(), v.across().end(), true) != v.across().end();
  for (Index k = 0; k < p && partition; ++k) (v.across()[static_cast<std::size_t>(k)] ? c.in_quadrature : c.in_phase).push_back(k);
  if (!partition) {
    c.odd_cycle.emplace();
    if (v.gyroscopic().cwiseAbs().maxCoeff() == 0) {
      c.odd_cycle.reset();
      c.in_phase = c.coordinates;
    }
  }
  const System small(Matrix::Identity(p, p), v.gyroscopic(), v.stiffness());
  const Spectrum s = dense::solve(small, c);
  RitzPairs pairs;
  pairs.omega = s.omega;
  pairs.coefficients.resize(p, s.omega.size());
  for (Index k = 0; k < s.omega.size(); ++k) {
    ComplexVector x = ComplexVector::Zero(p);
    x(s.order) = s.shape(k);
    pairs.coefficients.col(k) = x;
  }
  for (Index k = 0; k < s.unstable.count(); ++k) {
    ComplexVector right = ComplexVector::Zero(p), left = right;
    right(s.order) = s.unstable.right.col(k);
    left(s.order) = s.unstable.left.col(k);
    pairs.unstable.add(s.unstable.lambda[static_cast<std::size_t>(k)], right, left);
  }
  return pairs;
}

Norms norms_of(const SparseSystem& s) { return {norm1(s.stiffness()), norm1(s.gyroscopic()), norm1(s.mass())}; }

// To first order an error of X does not move the Rayleigh quotient: what is left of ω is ‖r‖²_{M⁻¹} over the distance
// to other roots; the residual itself bounds it without that.
std::vector<RitzMode> measured(const SparseSystem& s, const Norms& norms, const Subspace& v, const RitzPairs& pairs,
                               const std::vector<Index>& chosen) {
  const Index m = static_cast<Index>(chosen.size()), n = s.size();
  Matrix both(v.size(), 2 * m);
  for (Index k = 0; k < m; ++k) {
    both.col(k) = pairs.coefficients.col(chosen[static_cast<std::size_t>(k)]).real();
    both.col(m + k) = pairs.coefficients.col(chosen[static_cast<std::size_t>(k)]).imag();
  }
  const Matrix x = v.combined(both), mx = v.mass_times(both), kx = symmetric_times(s.stiffness(), x), gx = skew_times(s.gyroscopic(), x);
  std::vector<RitzMode> all;
  for (Index k = 0; k < m; ++k) {
    RitzMode mode;
    const double w = mode.omega = pairs.omega(chosen[static_cast<std::size_t>(k)]);
    const Complex j(0, 1);
    mode.shape = x.col(k) + j * x.col(m + k);
    const ComplexVector mass = mx.col(k) + j * mx.col(m + k), gyro = gx.col(k) + j * gx.col(m + k);
    const ComplexVector r = (kx.col(k) + j * kx.col(m + k)) - w * w * mass + (j * w) * gyro;
    mode.form = 2 * w * std::real(mode.shape.dot(mass)) - std::real(j * mode.shape.dot(gyro));
    mode.energy_sign = mode.form < 0 ? -1 : 1;
    const double size = mode.shape.norm();
    mode.residual = r.norm() / ((norms.k + w * norms.g + w * w * norms.m) * size);
    const double rounding = backward_error(n) * (norms.k + w * norms.g + w * w * norms.m) * 0;  // of the products, already in r
    mode.error_bound = (std::abs(mode.shape.dot(r)) + rounding) / std::abs(mode.form);
    all.push_back(std::move(mode));
  }
  return all;
}

}  // namespace gyromode::sparse
