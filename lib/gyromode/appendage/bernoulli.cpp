#include "gyromode/appendage/bernoulli.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"

#include <Eigen/LU>

#include <array>
#include <cmath>
#include <numbers>

namespace gyromode {

namespace {

// Krylov's functions K_i(x) = Σ κ^m x^{4m+i}/(4m + i)!, i = 0 … 7.
template <class T>
std::array<T, 8> krylov(const T& kappa, double x) {
  std::array<T, 8> k{};
  double power = 1;  // x^i/i!
  for (int i = 0; i < 8; ++i) {
    T part = power;
    T sum = 0;
    for (int m = 1; m < 40; ++m) {
      sum += part;
      const double n = 4 * m + i;
      part *= kappa * (x * x * x * x / (n * (n - 1) * (n - 2) * (n - 3)));
      if (std::abs(part) <= 0.1 * epsilon * std::abs(sum)) break;
    }
    k[static_cast<std::size_t>(i)] = sum;
    power *= x / (i + 1);
  }
  return k;
}

// ψ = l₁K₄ + l₂K₅ + ψ₂K₂ + ψ₃K₃ with the two conditions at the tip, A(ψ₂, ψ₃) = −R(l₁, l₂), and C = P − Z A⁻¹ R. Sums
// of terms of one sign but for the determinants; that of Q is φ times the determinant of [A R; Z P].
template <class T>
FieldResponse<T> by_series(const T& kappa, double l, double e) {
  const auto k = krylov(kappa, l);
  Eigen::Matrix<T, 4, 4> m;
  m << k[0], k[1], k[2], k[3],                                                               // ψ″(l)
      kappa * (k[3] + e * k[2]), k[0] + e * kappa * k[3], k[1] + e * k[0], k[2] + e * k[1],  // ψ‴(l) + ε(κψ + load)
      k[3] + e * k[2], k[4] + e * k[3], k[5] + e * k[4], k[6] + e * k[5],                    // ∫ ψ
      // ∫ sψ
      l * k[3] - k[4] + e * l * k[2], l * k[4] - k[5] + e * l * k[3], l * k[5] - k[6] + e * l * k[4], l * k[6] - k[7] + e * l * k[5];
  const T phi = m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0);
  Eigen::Matrix<T, 2, 2> adjugate;
  adjugate << m(1, 1), -m(0, 1), -m(1, 0), m(0, 0);
  const Eigen::Matrix<T, 2, 2> q =
      phi * m.template bottomRightCorner<2, 2>() - m.template bottomLeftCorner<2, 2>() * adjugate * m.template topRightCorner<2, 2>();
  return {phi, q(0, 0), 0.5 * (q(0, 1) + q(1, 0)), q(1, 1), m.determinant(), T(0), T(0), T(0)};
}

// φ = Δ/cosh b, zero at the clamped frequencies.
template <class T>
T scaled_determinant(const T& b, const T& r) {
  return 1.0 / std::cosh(b) + std::cos(b) + r * (std::cos(b) * std::tanh(b) - std::sin(b));
}

// Q = −N/κ², lump = M/κ with N/Δ the dynamic stiffness of the root and M the mass matrix of the rigid beam; hyperbolic
// functions divided by cosh b, so that nothing overflows.
template <class T>
FieldResponse<T> closed_form(const T& kappa, double l, double e) {
  const T beta = std::sqrt(std::sqrt(kappa));
  const T b = beta * l;
  const T r = e * beta;
  const T c = std::cos(b);
  const T s = std::sin(b);
  const T th = std::tanh(b);
  const T by = kappa * kappa;
  return {scaled_determinant(b, r),
          beta * beta * beta * (c * th + s + 2.0 * r * c) / by,
          beta * beta * (s * th + r * (s + c * th)) / by,
          beta * (s - c * th + 2.0 * r * s * th) / by,
          (1.0 / std::cosh(b) - c + r * (s - c * th)) / (by * kappa),
          (l + e) / kappa,
          (0.5 * l * l + e * l) / kappa,
          (l * l * l / 3 + e * l * l) / kappa};
}

template <class T>
FieldResponse<T> answer(const T& kappa, double length, double tip_length) {
  constexpr double series_up_to = 2;  // b = κ^¼ l: below, the closed form cancels; above, the series does
  const double b = std::sqrt(std::sqrt(std::abs(kappa))) * length;
  return b < series_up_to ? by_series(kappa, length, tip_length) : closed_form(kappa, length, tip_length);
}

}  // namespace

FieldResponse<double> cantilever_answer(double kappa, double length, double tip_length) { return answer(kappa, length, tip_length); }
FieldResponse<Complex> cantilever_answer(Complex kappa, double length, double tip_length) { return answer(kappa, length, tip_length); }

// ψ = particular + c₁ cos βs + c₂ sin βs + c₃ e^{−βs} + c₄ e^{β(s−l)}: no large numbers.
Vector cantilever_shape(double kappa, double length, double tip_length, double first, double second, const std::vector<double>& stations) {
  const double least = std::pow(0.3 / length, 4);  // below, the particular solution −load/κ cancels; the shape is static there
  kappa = std::max(kappa, least);
  const double beta = std::sqrt(std::sqrt(kappa));
  const double e = tip_length;
  const auto basis = [&](double s) {
    Eigen::Matrix<double, 4, 4> d;  // rows: ψ, ψ′, ψ″, ψ‴
    const double c = std::cos(beta * s), n = std::sin(beta * s), down = std::exp(-beta * s), up = std::exp(beta * (s - length));
    d << c, n, down, up, -beta * n, beta * c, -beta * down, beta * up, -beta * beta * c, -beta * beta * n, beta * beta * down,
        beta * beta * up, beta * beta * beta * n, -beta * beta * beta * c, -beta * beta * beta * down, beta * beta * beta * up;
    return d;
  };
  const Eigen::Matrix4d root = basis(0), tip = basis(length);
  Eigen::Matrix4d conditions;
  conditions << root.row(0), root.row(1), tip.row(2), tip.row(3) + e * kappa * tip.row(0);
  // −load/κ carries its own load at the tip
  const Eigen::Vector4d c = small::solve_fully_pivoted(Matrix(conditions), Vector{{first / kappa, second / kappa, 0, 0}});
  Vector shape(static_cast<Index>(stations.size()));
  for (Index i = 0; i < shape.size(); ++i) {
    const double s = stations[static_cast<std::size_t>(i)];
    shape(i) = basis(s).row(0) * c - (first + second * s) / kappa;
  }
  return shape;
}

Index cantilever_poles_below(double kappa, double length, double phi) {
  const Index half_waves = static_cast<Index>(std::sqrt(std::sqrt(kappa)) * length / std::numbers::pi);
  return half_waves + ((phi < 0) == (half_waves % 2 == 0) ? 1 : 0);
}

}  // namespace gyromode
