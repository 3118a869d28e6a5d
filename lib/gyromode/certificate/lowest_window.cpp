#include "gyromode/base/error.h"
#include "gyromode/certificate/window_ends.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

// A frequency below which there are enough roots, and one more to show the gap; of infinitely many.
double far_enough(const CountedSpectrum& s, Index lowest, const Window& requested) {
  constexpr Index rigid_bodies = 2, to_show_the_gap = 1;
  const Index before = s.below(requested.a);
  const auto found = [&](double b) { return s.below(b) - before; };
  double b = std::max(2.0, 2 * requested.a);
  while (b < requested.b && b < s.reach() && found(b) < lowest + rigid_bodies + to_show_the_gap) b *= 1.5;
  if (b < s.reach()) return b;
  const Index within = std::max<Index>(found(s.reach()) - 1, 0);  // one may be a rigid-body root
  if (within < lowest && s.reach() < requested.b) {
    throw InvalidArgument(fmt::format("{} modes were asked for, and {} are within reach: {}", lowest, within, s.reach_reason()));
  }
  return s.reach();
}

}  // namespace

FilledWindow lowest_window(const CountedSpectrum& s, Index lowest, const Window& requested, const Progress& progress) {
  if (lowest > s.most_roots())
    throw TooLarge(fmt::format("{} modes were asked for: at most {} are listed at a time; ask for windows", lowest, s.most_roots()));
  std::optional<RootRange> in_order = s.lowest_roots(lowest, requested, progress);
  const double b = s.finite() || in_order ? requested.b : std::min(far_enough(s, lowest, requested), requested.b);
  RootRange found = in_order ? std::move(*in_order) : s.roots({requested.a, b}, progress);
  const std::vector<CountedRoot>& all = found.roots;
  Index seen = 0;
  for (std::size_t i = 0; i + 1 < all.size(); ++i) {
    if (all[i].omega < requested.a) continue;
    if (!all[i].rigid_body) ++seen;
    const double from = all[i].omega + 4 * all[i].error, to = all[i + 1].omega - 4 * all[i + 1].error;
    if (seen < lowest || !(to > from)) continue;
    const double middle = 0.5 * (from + to), end = found.all_below > from ? std::min(middle, found.all_below) : middle;
    return {{requested.a, std::min(end, requested.b)}, std::move(found)};
  }
  if (found.all_below > 0) return {{requested.a, std::min(found.all_below, requested.b)}, std::move(found)};
  return {{requested.a, b}, std::move(found)};
}

}  // namespace gyromode
