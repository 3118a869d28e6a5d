#include "gyromode/appendage/bernoulli.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gyromode {

namespace {

// Krylov's functions K_i(x) = Σ κ^m x^{4m+i}/(4m + i)!, i = 0 … 3.
std::array<double, 4> krylov(double kappa, double x) {
  std::array<double, 4> k{};
  double term = 1;  // x^i/i!
  for (int i = 0; i < 4; ++i) {
    double part = term;
    for (int m = 1; m < 40; ++m) {
      k[static_cast<std::size_t>(i)] += part;
      const double n = 4 * m + i;
      part *= kappa * x * x * x * x / (n * (n - 1) * (n - 2) * (n - 3));
      if (part <= 0.1 * std::numeric_limits<double>::epsilon() * k[static_cast<std::size_t>(i)]) break;
    }
    term *= x / (i + 1);
  }
  return k;
}

// ψ = ψ₀K₀ + ψ₀′K₁ + ψ₂K₂ + ψ₃K₃ with the two conditions at the tip; every sum has terms of one sign but those of the determinants.
Eigen::Matrix2d by_series(double kappa, double l, double e) {
  const auto k = krylov(kappa, l);
  Eigen::Matrix2d tip;
  tip << k[0], k[1], kappa * (k[3] + e * k[2]), k[0] + e * kappa * k[3];
  Eigen::Matrix2d root;
  root << k[2], k[3], k[1] + e * k[0], k[2] + e * k[1];
  const Eigen::Matrix2d response = -kappa * (tip.inverse() * root);  // (ψ₂, ψ₃) for unit ψ₀ and ψ₀′
  Eigen::Matrix2d d;
  d << response(1, 0), response(1, 1), response(1, 1), -response(0, 1);
  return d;
}

// Δ/cosh b: zero at the clamped frequencies.
double scaled_determinant(double b, double r) { return 1 / std::cosh(b) + std::cos(b) + r * (std::cos(b) * std::tanh(b) - std::sin(b)); }

// The closed form with hyperbolic functions divided by cosh b, so that nothing overflows.
Eigen::Matrix2d closed_form(double kappa, double l, double e) {
  const double beta = std::sqrt(std::sqrt(kappa));
  const double b = beta * l;
  const double r = e * beta;
  const double c = std::cos(b);
  const double s = std::sin(b);
  const double th = std::tanh(b);
  const double delta = scaled_determinant(b, r);
  const double cross = -beta * beta * (s * th + r * (s + c * th)) / delta;
  Eigen::Matrix2d d;
  d << -beta * beta * beta * (c * th + s + 2 * r * c) / delta, cross, cross, -beta * (s - c * th + 2 * r * s * th) / delta;
  return d;
}

}  // namespace

Eigen::Matrix2d cantilever_stiffness(double kappa, double length, double tip_length) {
  constexpr double series_up_to = 2;  // b = κ^¼ l: below, the closed form cancels; above, the series does
  const double b = std::sqrt(std::sqrt(kappa)) * length;
  return b < series_up_to ? by_series(kappa, length, tip_length) : closed_form(kappa, length, tip_length);
}

Index cantilever_poles_below(double kappa, double length, double tip_length) {
  const double beta = std::sqrt(std::sqrt(kappa));
  const double b = beta * length;
  const Index half_waves = static_cast<Index>(b / std::numbers::pi);  // one frequency in every interval [nπ, (n + 1)π)
  const double sign = half_waves % 2 == 0 ? 1 : -1;
  return half_waves + (sign * scaled_determinant(b, tip_length * beta) < 0 ? 1 : 0);
}

}  // namespace gyromode
