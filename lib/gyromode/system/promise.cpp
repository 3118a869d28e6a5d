#include "gyromode/system/promise.h"

#include "gyromode/lapack/triangular.h"
#include "gyromode/system/scale.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <unordered_set>

namespace gyromode {

namespace {

// The pair (i, j), i ≥ j, where |a_ij − sign·a_ji| is largest, and that number.
struct Breach {
  Index i = 0, j = 0;
  double size = 0;
};

Breach largest_breach(const Matrix& a, double sign) {
  Breach worst;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = j; i < a.rows(); ++i) {
      const double size = std::abs(a(i, j) - sign * a(j, i));
      if (size > worst.size) worst = {i, j, size};
    }
  }
  return worst;
}

double require_symmetry(std::string_view name, const Matrix& a, double sign) {
  const double largest = a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff();
  if (largest == 0) return 0;
  const Breach b = largest_breach(a, sign);
  if (b.size <= symmetry_tolerance * largest) return b.size / largest;
  const std::string law = fmt::format("{0} must satisfy {0} = {1}{0}ᵀ", name, sign > 0 ? "" : "−");
  if (b.i == b.j) {
    throw BrokenPromise(fmt::format("{}: the diagonal entry ({},{}) = {:.6g} must be 0, it is {:.2g} % of the largest entry", law, b.i + 1, b.j + 1,
                                    a(b.i, b.j), 100 * std::abs(a(b.i, b.j)) / largest));
  }
  throw BrokenPromise(fmt::format("{}: entries ({},{}) = {:.6g} and ({},{}) = {:.6g} {} by {:.3g}, {:.2g} % of the largest entry", law, b.j + 1, b.i + 1,
                                  a(b.j, b.i), b.i + 1, b.j + 1, a(b.i, b.j), sign > 0 ? "differ" : "miss opposite signs", b.size,
                                  100 * b.size / largest));
}

}  // namespace

Labels default_labels(Index n) {
  Labels labels(static_cast<std::size_t>(n));
  for (std::size_t i = 0; i < labels.size(); ++i) labels[i] = fmt::format("q{}", i + 1);
  return labels;
}

void require_square(std::string_view name, const Matrix& a) {
  if (a.rows() != a.cols()) throw BrokenPromise(fmt::format("{} must be square: it has {} rows and {} columns", name, a.rows(), a.cols()));
  if (a.rows() == 0) throw BrokenPromise(fmt::format("{} must have at least one coordinate: it is empty", name));
}

void require_finite(std::string_view name, const Matrix& a) {
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = 0; i < a.rows(); ++i) {
      if (!std::isfinite(a(i, j))) throw BrokenPromise(fmt::format("{} must be finite: entry ({},{}) = {}", name, i + 1, j + 1, a(i, j)));
    }
  }
}

void require_labels(const Labels& labels, Index n) {
  if (static_cast<Index>(labels.size()) != n) {
    throw BrokenPromise(fmt::format("labels must name every coordinate once: {} labels for {} coordinates", labels.size(), n));
  }
  std::unordered_set<std::string_view> seen;
  for (const std::string& label : labels) {
    if (label.empty()) throw BrokenPromise("labels must not be empty");
    if (!seen.insert(label).second) throw BrokenPromise(fmt::format("labels must differ: '{}' is given twice", label));
  }
}

void require_positive_definite(std::string_view name, const Matrix& a, const Labels& labels) {
  const Index n = a.rows();
  const double epsilon = std::numeric_limits<double>::epsilon();
  for (Index i = 0; i < n; ++i) {
    if (!(a(i, i) > 0)) {
      throw BrokenPromise(fmt::format("{} must be positive definite: diagonal entry ({},{}) = {:.6g} of coordinate '{}' is not above 0", name, i + 1,
                                      i + 1, a(i, i), labels[static_cast<std::size_t>(i)]));
    }
  }
  Matrix l = scaled(a, unit_diagonal_scale(a));
  const auto failed = lapack::cholesky(l);
  Index weakest = failed.value_or(0);
  double pivot = 0;
  if (!failed) {
    pivot = l.diagonal().cwiseAbs2().minCoeff(&weakest);
    if (pivot > static_cast<double>(n) * epsilon) return;
  }
  throw BrokenPromise(fmt::format("{} must be positive definite: with unit diagonal its pivot {} (coordinate '{}') is {}{:.3g}, not above n ε = {:.2g}",
                                  name, weakest + 1, labels[static_cast<std::size_t>(weakest)], failed ? "≤ " : "", pivot,
                                  static_cast<double>(n) * epsilon));
}

double require_symmetric(std::string_view name, const Matrix& a) { return require_symmetry(name, a, 1); }
double require_skew(std::string_view name, const Matrix& a) { return require_symmetry(name, a, -1); }

Matrix symmetric_part(const Matrix& a) { return 0.5 * (a + a.transpose()); }
Matrix skew_part(const Matrix& a) { return 0.5 * (a - a.transpose()); }

}  // namespace gyromode
