#include "gyromode/impedance/isolate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

using Counts = std::vector<Index>;

Counts counts_at(const BlockedImpedance& h, double omega, const GrowingCount& growing) {
  const Lifted lifted = h.impedance.at(omega);
  Counts counts;
  for (std::size_t b = 0; b < h.blocks.size(); ++b) {
    counts.push_back(growing(static_cast<Index>(b), omega, state_of(h.blocks[b], lifted).count));
  }
  return counts;
}

struct Interval {
  double a, b;
  Counts at_a, at_b;
};

}  // namespace

std::vector<Bracket> isolate(const BlockedImpedance& h, double a, double b, const GrowingCount& growing) {
  std::vector<Bracket> found;
  std::vector<Interval> open{{a, b, counts_at(h, a, growing), counts_at(h, b, growing)}};
  while (!open.empty()) {
    const Interval i = std::move(open.back());
    open.pop_back();
    // Narrower than the rounding of the roots themselves nothing can be told apart.
    const bool narrow = i.b - i.a <= 8 * h.impedance.rounding(i.b) * i.b;
    bool more = false;
    for (std::size_t k = 0; k < i.at_a.size(); ++k) more = more || i.at_b[k] - i.at_a[k] > 1;
    if (more && !narrow) {
      const double mid = 0.5 * (i.a + i.b);
      Counts at_mid = counts_at(h, mid, growing);
      // On a root to rounding a count may lie beyond those of its neighbours: it is theirs.
      for (std::size_t k = 0; k < at_mid.size(); ++k) at_mid[k] = std::clamp(at_mid[k], std::min(i.at_a[k], i.at_b[k]), std::max(i.at_a[k], i.at_b[k]));
      open.push_back({mid, i.b, at_mid, i.at_b});
      open.push_back({i.a, mid, i.at_a, std::move(at_mid)});
      continue;
    }
    for (std::size_t k = 0; k < i.at_a.size(); ++k) {
      const Index roots = i.at_b[k] - i.at_a[k];
      if (roots > 0) found.push_back({static_cast<Index>(k), i.a, i.b, i.at_a[k], roots});
    }
  }
  return found;
}

}  // namespace gyromode
