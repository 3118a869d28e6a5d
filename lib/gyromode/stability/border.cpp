#include "gyromode/stability/border.h"

#include <algorithm>

namespace gyromode {

namespace {

struct Gap {
  double a, b;
  double width() const { return b - a; }
};

// The widest between neighbours of lo, the points without a verdict, ascending, and hi.
Gap widest(double lo, const std::vector<double>& without, double hi) {
  Gap found{without.empty() ? lo : without.back(), hi};
  double before = lo;
  for (const double x : without) {
    if (x - before > found.width()) found = {before, x};
    before = x;
  }
  return found;
}

}  // namespace

bool BorderSearch::narrow(Border& border) {
  std::vector<double> without;  // a verdict of their own
  while (left_ > 0) {
    const Gap gap = widest(border.lo, without, border.hi);
    const double x = 0.5 * (gap.a + gap.b), width = border.hi - border.lo;
    const double enough = std::max(resolution * range_, without.empty() ? 0 : of_band * width);
    if (!(gap.width() > enough) || !(x > gap.a) || !(x < gap.b)) return true;
    const StabilityPoint here = verdict_(x);
    ++evaluations_;
    --left_;
    const bool as_from = here.decided() && !here.differs(border.from), as_to = here.decided() && !here.differs(border.to);
    if (here.decided() && !as_from && !as_to && width > narrowest_verdict * range_) {
      open_.push_back({x, border.hi, here, border.to});
      open_.push_back({border.lo, x, border.from, here});
      return false;
    }
    if (as_from == as_to) {
      without.insert(std::upper_bound(without.begin(), without.end(), x), x);
    } else if (as_from) {
      border.lo = x;
      if (!border.from.balance.closed) border.from = here;
      std::erase_if(without, [&](double u) { return u < x; });
    } else {
      border.hi = x;
      if (!border.to.balance.closed) border.to = here;
      std::erase_if(without, [&](double u) { return u > x; });
    }
  }
  return true;
}

std::vector<Border> BorderSearch::between(double a, const StabilityPoint& at_a, double b, const StabilityPoint& at_b) {
  std::vector<Border> found;
  left_ = most_evaluations;
  open_.assign(1, {a, b, at_a, at_b});
  while (!open_.empty()) {
    Border border = std::move(open_.back());
    open_.pop_back();
    if (narrow(border)) found.push_back(std::move(border));
  }
  return found;
}

std::vector<Border> merged(const std::vector<Border>& borders, double width) {
  std::vector<Border> one;
  for (const Border& b : borders) {
    if (!one.empty() && b.lo - one.back().hi <= width) {
      one.back().hi = b.hi;
      one.back().to = b.to;
    } else {
      one.push_back(b);
    }
  }
  std::erase_if(one, [](const Border& b) { return !b.from.differs(b.to); });
  return one;
}

}  // namespace gyromode
