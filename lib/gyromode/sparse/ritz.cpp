#include "gyromode/sparse/ritz.h"

#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/rounding_sizes.h"

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

Norms norms_of(const SparseSystem& s) {
  if (const Basis* b = s.basis()) return {b->norm_k, b->norm_g, b->norm_m};
  return {norm1(s.stiffness()), norm1(s.gyroscopic()), norm1(s.mass())};
}

// As the Rayleigh quotient is stationary, within ρ²/gap to second order; roots nearer than 4ρ are one with it.
double error_of(double rho, double omega, const Vector& all) {
  double gap = 2 * omega;  // to its mirror image
  for (Index i = 0; i < all.size(); ++i) {
    const double d = std::abs(all(i) - omega);
    if (d > 4 * rho) gap = std::min(gap, d);
  }
  return std::min(rho, rho * rho / gap);
}

// In the norm of M an eigenvalue of H(ω) is within ρ' = ‖r‖_{M⁻¹} / ‖X‖_M of zero: ω within ρ = ρ'‖X‖²_M / |form| of a
// root to first order, and as the Rayleigh quotient is stationary within ρ²/gap to second. M⁻¹ by the diagonal of M.
// Some at a time, so that their products need little memory.
std::vector<RitzMode> measured(const SparseSystem& s, const Norms& norms, const Subspace& v, const RitzPairs& pairs,
                               const std::vector<Index>& chosen) {
  constexpr Index together = 4;
  const Vector inverse_mass = s.mass().diagonal().cwiseInverse();
  const Complex j(0, 1);
  const RoundingSizes sizes(s);
  std::vector<RitzMode> all;
  for (std::size_t first = 0; first < chosen.size(); first += together) {
    const Index m = std::min<Index>(together, static_cast<Index>(chosen.size() - first));
    Matrix both(v.size(), 2 * m);
    for (Index k = 0; k < m; ++k) {
      both.col(k) = pairs.coefficients.col(chosen[first + static_cast<std::size_t>(k)]).real();
      both.col(m + k) = pairs.coefficients.col(chosen[first + static_cast<std::size_t>(k)]).imag();
    }
    const Matrix x = v.combined(both), mx = v.mass_times(both), kx = symmetric_times(s.stiffness(), x), gx = skew_times(s.gyroscopic(), x);
    for (Index k = 0; k < m; ++k) {
      const Index root = chosen[first + static_cast<std::size_t>(k)];
      RitzMode mode;
      const double w = mode.omega = pairs.omega(root);
      mode.shape = x.col(k) + j * x.col(m + k);
      const ComplexVector mass = mx.col(k) + j * mx.col(m + k), gyro = gx.col(k) + j * gx.col(m + k);
      const ComplexVector r = (kx.col(k) + j * kx.col(m + k)) - w * w * mass + (j * w) * gyro;
      mode.form = 2 * w * std::real(mode.shape.dot(mass)) - std::real(j * mode.shape.dot(gyro));
      mode.energy_sign = mode.form < 0 ? -1 : 1;
      const double size = mode.shape.norm();
      mode.residual = r.norm() / ((norms.k + w * norms.g + w * w * norms.m) * size);
      const double rho = std::sqrt(r.cwiseAbs2().cwiseProduct(inverse_mass).sum() * std::real(mode.shape.dot(mass))) / std::abs(mode.form);
      mode.error_bound = error_of(rho, w, pairs.omega) + sizes.of(mode.shape, w) / std::abs(mode.form);
      all.push_back(std::move(mode));
    }
  }
  return all;
}

MeasuredRoots measured_in(const SparseSystem& s, const Norms& norms, const Subspace& v, const Window& range) {
  MeasuredRoots all;
  if (v.size() == 0) return all;
  const RitzPairs pairs = ritz_pairs(v);
  std::vector<Index> chosen;
  for (Index k = 0; k < pairs.omega.size(); ++k) {
    if (range.contains(pairs.omega(k))) chosen.push_back(k);
  }
  all.modes = measured(s, norms, v, pairs, chosen);
  for (Index k = 0; range.a == 0 && k < pairs.unstable.count(); ++k) {
    const Complex lambda = pairs.unstable.lambda[static_cast<std::size_t>(k)];
    const ComplexVector c = pairs.unstable.right.col(k), d = pairs.unstable.left.col(k);
    Matrix parts(c.size(), 4);
    parts << c.real(), c.imag(), d.real(), d.imag();
    const Matrix x = v.combined(parts), mx = v.mass_times(parts), kx = symmetric_times(s.stiffness(), x),
                 gx = skew_times(s.gyroscopic(), x);
    const auto joined = [](const Matrix& a, Index at) { return ComplexVector(a.col(at) + Complex(0, 1) * a.col(at + 1)); };
    const ComplexVector shape = joined(x, 0), left = joined(x, 2);
    const ComplexVector r = joined(kx, 0) + lambda * joined(gx, 0) + lambda * lambda * joined(mx, 0);
    const double size = std::abs(lambda);
    const Complex slope = left.dot(2.0 * lambda * joined(mx, 0) + joined(gx, 0));
    all.unstable.push_back({lambda, r.norm() / ((norms.k + size * norms.g + size * size * norms.m) * shape.norm()),
                            r.norm() * left.norm() / std::abs(slope), shape});
  }
  return all;
}

}  // namespace gyromode::sparse
