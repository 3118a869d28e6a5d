#pragma once

#include "gyromode/stability/stability_point.h"

#include <functional>
#include <vector>

namespace gyromode {

/// Between lo, where the verdict is `from`, and hi, where it is `to`, it changes. Nothing between them is decided, or
/// they are neighbours to the resolution.
struct Border {
  double lo = 0, hi = 0;
  StabilityPoint from, to;

  double middle() const { return 0.5 * (lo + hi); }
};

/// Borders between decided verdicts along a line, in a bounded number of evaluations.
///
/// Of two different verdicts at the ends of an interval bisection keeps one at either end: it comes down to one border
/// whatever rounding makes of the verdicts beside it. Points without a verdict are a band that belongs to the border
/// around it, and its ends are looked for no closer than its width asks. A third verdict parts the interval in two. A
/// verdict that holds over less than `narrowest_verdict` is none of its own: it belongs to the band.
class BorderSearch {
 public:
  static constexpr double resolution = 1e-14;        ///< of the range of the parameter, at which a border is a point
  static constexpr double narrowest_verdict = 1e-8;  ///< of the range
  static constexpr double of_band = 0.125;           ///< widest gap between points of a band without a verdict, relative to its width
  static constexpr Index most_evaluations = 256;     ///< between two points; what is then still open is a border as wide as it is

  using Line = std::function<StabilityPoint(double)>;
  BorderSearch(Line verdict, double range) : verdict_(std::move(verdict)), range_(range) {}

  /// Between a < b, with decided verdicts that differ, ascending.
  std::vector<Border> between(double a, const StabilityPoint& at_a, double b, const StabilityPoint& at_b);
  Index evaluations() const { return evaluations_; }  ///< in all

 private:
  // True: `border` is narrow. False: a third verdict was met, and both parts wait in open_.
  bool narrow(Border& border);

  Line verdict_;
  double range_;
  Index evaluations_ = 0, left_ = 0;
  std::vector<Border> open_;
};

/// Borders with a verdict between them that is narrower than `width` made one; those that then have one verdict on both
/// sides left out. `borders` are ascending and follow each other.
std::vector<Border> merged(const std::vector<Border>& borders, double width);

}  // namespace gyromode
