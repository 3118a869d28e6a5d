#include "gyromode/system/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gyromode {

namespace {

// ⌊e/2⌋ for negative e, too.
int half_down(int e) { return e >= 0 ? e / 2 : -((1 - e) / 2); }

// The largest exponent of |a_ik| · 2^(rows_i + columns_k), or `none` where a is zero.
int largest_exponent(const Matrix& a, const int* rows, const int* columns, int none) {
  int largest = none;
  const bool same = a.rows() > 0 && std::all_of(rows, rows + a.rows(), [&](int e) { return e == rows[0]; });
  for (Index k = 0; k < a.cols(); ++k) {
    if (same) {  // no logarithm an entry
      const double top = a.col(k).cwiseAbs().maxCoeff();
      if (top > 0) largest = std::max(largest, std::ilogb(top) + rows[0] + columns[k]);
      continue;
    }
    for (Index i = 0; i < a.rows(); ++i) {
      if (a(i, k) != 0) largest = std::max(largest, std::ilogb(a(i, k)) + rows[i] + columns[k]);
    }
  }
  return largest;
}

}  // namespace

Units natural_units(const Vector& mass_diagonal, const Matrix& k1, const Matrix& k2, const Matrix& g, bool blocks) {
  constexpr int none = std::numeric_limits<int>::min() / 4;
  const Index n = mass_diagonal.size();
  std::vector<int> exponents(static_cast<std::size_t>(n));
  Units units{Vector(n), 1};
  for (Index i = 0; i < n; ++i) {
    exponents[static_cast<std::size_t>(i)] = -half_down(std::ilogb(mass_diagonal(i)));
    units.coordinate(i) = std::ldexp(1.0, exponents[static_cast<std::size_t>(i)]);
  }
  const int* first = exponents.data();
  const int* second = blocks ? first + k1.rows() : first;
  const int rate2 = std::max({2 * largest_exponent(g, first, second, none / 2), largest_exponent(k1, first, first, none),
                              largest_exponent(k2, second, second, none)});
  constexpr int most = 500;  // its square is a double, too
  if (rate2 > none) units.time = std::ldexp(1.0, std::clamp(-half_down(rate2), -most, most));
  return units;
}

void change_units_of(Matrix& a, const Vector& rows, const Vector& columns, double factor) {
  if (a.size() == 0) return;
  const double widest = std::max({rows.maxCoeff(), columns.maxCoeff(), factor, 1.0});
  const double narrowest = std::min({rows.minCoeff(), columns.minCoeff(), factor, 1.0});
  const bool safe = widest <= 0x1p200 && narrowest >= 0x1p-200;
  for (Index k = 0; k < a.cols(); ++k) {
    if (safe) {
      a.col(k).array() *= rows.array() * (factor * columns(k));
      continue;
    }
    for (Index i = 0; i < a.rows(); ++i)
      a(i, k) = a(i, k) == 0 ? 0 : std::ldexp(a(i, k), std::ilogb(rows(i)) + std::ilogb(columns(k)) + std::ilogb(factor));
  }
}

}  // namespace gyromode
