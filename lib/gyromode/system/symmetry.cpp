#include "gyromode/system/symmetry.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gyromode {

namespace {

// The pair (i, j), i ≥ j, that departs most by some measure.
struct Departure {
  Index i = 0, j = 0;
  double size = 0;     // |a_ij − sign·a_ji|
  double measure = 0;  // 0: none departs
};

// The largest by size, and the largest over what is let in of it as rounding.
struct Departures {
  double largest_entry = 0;
  Departure largest, worst;
  double own_scale = 0;  // the largest over √(r_i r_j)
};

constexpr double size_rounding = 1e-12, own_rounding = 1e-8;

double allowance(double largest, double row_i, double row_j) {
  return std::max(size_rounding * largest, own_rounding * std::sqrt(row_i) * std::sqrt(row_j));
}

Departures departures(const Matrix& a, int sign) {
  const Vector rows = a.cwiseAbs().rowwise().maxCoeff().cwiseMax(a.cwiseAbs().colwise().maxCoeff().transpose());
  Departures d;
  d.largest_entry = rows.size() > 0 ? rows.maxCoeff() : 0;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = j; i < a.rows(); ++i) {
      const double size = std::abs(a(i, j) - sign * a(j, i));
      if (size == 0) continue;
      const double ratio = size / allowance(d.largest_entry, rows(i), rows(j));
      d.own_scale = std::max(d.own_scale, size / (std::sqrt(rows(i)) * std::sqrt(rows(j))));
      if (size > d.largest.measure) d.largest = {i, j, size, size};
      if (!(ratio <= d.worst.measure)) d.worst = {i, j, size, ratio};
    }
  }
  return d;
}

std::string broken(std::string_view name, const Matrix& a, int sign, const Departure& d, double largest) {
  const std::string law = fmt::format("{0} must satisfy {0} = {1}{0}ᵀ", name, sign > 0 ? "" : "−");
  if (d.i == d.j) {
    return fmt::format("{}: the diagonal entry ({},{}) = {:.6g} must be 0, it is {:.2g} % of the largest entry", law, d.i + 1, d.j + 1,
                       a(d.i, d.j), 100 * std::abs(a(d.i, d.j)) / largest);
  }
  return fmt::format("{}: entries ({},{}) = {} and ({},{}) = {} {} by {:.3g}, {:.2g} % of the largest entry", law, d.j + 1, d.i + 1,
                     a(d.j, d.i), d.i + 1, d.j + 1, a(d.i, d.j), sign > 0 ? "differ" : "miss opposite signs", d.size,
                     100 * d.size / largest);
}

}  // namespace

bool is_rounding(double departure, double largest, double row_i, double row_j) { return departure <= allowance(largest, row_i, row_j); }

bool Repair::doubtful() const { return !asked && own_scale > own_rounding && (!largest_effect || *largest_effect > error_bound); }

std::string Repair::in_words() const {
  const bool skew = matrix == "G";
  std::string words = fmt::format("{} departs from {}symmetry by {:.2g} of its largest entry at ({},{}), and its {}symmetric part is used",
                                  matrix, skew ? "skew-" : "", departure, row + 1, column + 1, skew ? "skew-" : "");
  if (!largest_effect) return words;
  words += asked ? fmt::format(": what was dropped changes the roots listed by up to some {:.2g} rad/s", *largest_effect)
                 : fmt::format(": what was dropped changes no root listed by more than {:.2g} rad/s", *largest_effect);
  if (*largest_effect == 0) return words;
  const bool within = *largest_effect <= error_bound;
  return words + fmt::format(" (at ω = {:.6g}, {} its error bound {:.2g})", effect_at, within ? "within" : "BEYOND", error_bound);
}

std::optional<Repair> made_symmetric(std::string_view name, Matrix& a, int sign, const Admission& admission) {
  const Departures d = departures(a, sign);
  if (d.worst.measure == 0) return std::nullopt;
  const bool let_in = d.worst.measure <= 1 || d.largest.size <= admission.symmetrise * d.largest_entry;
  if (admission.strict || !let_in) throw LawBroken::of(name, broken(name, a, sign, d.worst, d.largest_entry));
  Repair r;
  r.matrix = name;
  r.row = d.largest.i;
  r.column = d.largest.j;
  r.size = d.largest.size;
  r.departure = d.largest.size / d.largest_entry;
  r.own_scale = d.own_scale;
  r.asked = d.worst.measure > 1;
  Matrix kept = sign > 0 ? symmetric_part(a) : skew_part(a);
  r.dropped = std::make_shared<const Matrix>(sign > 0 ? skew_part(a) : symmetric_part(a));
  a = std::move(kept);
  return r;
}

bool departs_by_rounding(const Matrix& a, int sign) { return departures(a, sign).worst.measure <= 1; }

Matrix symmetric_part(const Matrix& a) { return 0.5 * a + 0.5 * a.transpose(); }
Matrix skew_part(const Matrix& a) { return 0.5 * a - 0.5 * a.transpose(); }

}  // namespace gyromode
