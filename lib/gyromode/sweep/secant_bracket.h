#pragma once

#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

/// A bracket of a sign change that secants narrow; an end that stays twice in a row has its value halved (Illinois), so
/// that both ends close in.
class SecantBracket {
 public:
  SecantBracket(double lo, double f_lo, double hi, double f_hi) : lo_(lo), hi_(hi), f_lo_(f_lo), f_hi_(f_hi) {}

  double width() const { return hi_ - lo_; }
  /// Whether the ends are within four roundings of each other.
  bool is_closed() const { return width() <= 4 * epsilon * std::max(std::abs(lo_), std::abs(hi_)); }
  /// Where the secant meets zero.
  double next() const { return (lo_ * f_hi_ - hi_ * f_lo_) / (f_hi_ - f_lo_); }
  bool holds(double t) const { return t > lo_ && t < hi_; }
  /// Takes a point inside with its value; true where it became the lower end.
  bool narrow(double t, double f) {
    const bool lower = (f < 0) == (f_lo_ < 0);
    (lower ? lo_ : hi_) = t;
    (lower ? f_lo_ : f_hi_) = f;
    const int side = lower ? -1 : 1;
    if (side == side_) (lower ? f_hi_ : f_lo_) /= 2;
    side_ = side;
    return lower;
  }

 private:
  double lo_, hi_, f_lo_, f_hi_;
  int side_ = 0;
};

}  // namespace gyromode
