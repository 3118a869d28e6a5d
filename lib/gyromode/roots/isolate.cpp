#include "gyromode/roots/isolate.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// The growing counts of all blocks at one frequency, their J, and their eigenvalues.
struct State {
  double omega = 0;
  std::vector<Index> count, plain;
  std::vector<BlockState> block;
};

State state_at(const BlockedImpedance& h, double omega, const MonotoneCount& growing) {
  const Lifted lifted = h.impedance.at(omega);
  State s{omega, {}, {}, {}};
  for (std::size_t b = 0; b < h.blocks.size(); ++b) {
    BlockState block = state_of(h.blocks[b], lifted);
    s.count.push_back(growing(static_cast<Index>(b), omega, block.count));
    s.plain.push_back(omega == 0 ? s.count.back() : block.count);  // at 0⁺ as the caller knows it
    s.block.push_back(std::move(block));
  }
  return s;
}

struct Interval {
  State a, b;
};

bool beyond_doubt(const BlockedImpedance& h, const State& s) {
  const double limit = 8 * h.impedance.rounding(s.omega);
  return std::none_of(s.block.begin(), s.block.end(), [&](const BlockState& b) { return std::abs(b.nearest) <= limit * b.size; });
}

// Near the middle of an interval, beside a root that stands there: on it a count may be one off, and by the growing
// count of one of negative energy roots would change sides.
State inside(const BlockedImpedance& h, const Interval& i, const MonotoneCount& growing) {
  State s = state_at(h, 0.5 * (i.a.omega + i.b.omega), growing);
  const double width = i.b.omega - i.a.omega;
  constexpr double wide = 1e-10;  // relative; narrower than this it may be roots all through
  if (!(width > wide * i.b.omega)) return s;
  for (const double fraction : {0.46, 0.55, 0.4}) {
    if (beyond_doubt(h, s)) break;
    s = state_at(h, i.a.omega + fraction * width, growing);
  }
  return s;
}

}  // namespace

Index crossing_position(const BlockState& state, Index count_lo, Index change) {
  return count_lo - state.poles_below - (change < 0 ? 1 : 0);
}

// Where the lifted coordinate of a pole has the other sign, the eigenvalue is not among those of the matrix: it is
// beyond the last of them.
double crossing(const BlockState& state, Index count_lo, Index change) {
  const Index n = state.eigenvalues.size();
  const Index at = crossing_position(state, count_lo, change);
  const double value = at >= n ? state.size : at < 0 ? -state.size : state.eigenvalues(at);
  return change < 0 ? -value : value;
}

bool isolate(const BlockedImpedance& h, double a, double b, const MonotoneCount& growing,
             const std::function<bool(const Bracket&)>& found) {
  std::vector<Interval> open{{state_at(h, a, growing), state_at(h, b, growing)}};
  while (!open.empty()) {
    const Interval i = std::move(open.back());
    open.pop_back();
    const std::size_t blocks = h.blocks.size();
    // Narrower than the rounding of the roots themselves nothing can be told apart.
    const bool narrow = i.b.omega - i.a.omega <= 8 * h.impedance.rounding(i.b.omega) * i.b.omega;
    bool more = false;
    for (std::size_t k = 0; k < blocks; ++k) more = more || i.b.count[k] - i.a.count[k] > 1;
    if (more && !narrow) {
      State mid = inside(h, i, growing);
      // On a root to rounding a count may lie beyond those of its neighbours: it is theirs.
      for (std::size_t k = 0; k < blocks; ++k) {
        const Index theirs = std::clamp(mid.count[k], std::min(i.a.count[k], i.b.count[k]), std::max(i.a.count[k], i.b.count[k]));
        mid.plain[k] += theirs - mid.count[k];
        mid.count[k] = theirs;
      }
      open.push_back({mid, i.b});
      open.push_back({i.a, std::move(mid)});
      continue;
    }
    for (std::size_t k = 0; k < blocks; ++k) {
      const Index roots = i.b.count[k] - i.a.count[k];
      if (roots <= 0) continue;
      const Index change = i.b.plain[k] - i.a.plain[k];
      const Bracket bracket{static_cast<Index>(k),
                            i.a.omega,
                            i.b.omega,
                            roots,
                            i.a.plain[k],
                            change,
                            crossing(i.a.block[k], i.a.plain[k], change),
                            crossing(i.b.block[k], i.a.plain[k], change)};
      if (!found(bracket)) return false;
    }
  }
  return true;
}

}  // namespace gyromode
