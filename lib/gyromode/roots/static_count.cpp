#include "gyromode/roots/static_count.h"

#include <algorithm>

namespace gyromode {

namespace {

bool in(const std::vector<Index>& set, Index i) { return std::find(set.begin(), set.end(), i) != set.end(); }

Block without(const Block& b, const std::vector<Index>& left_out) {
  Block rest;
  rest.real = b.real;
  for (std::size_t k = 0; k < b.coordinates.size(); ++k) {
    if (in(left_out, b.coordinates[k])) continue;
    rest.coordinates.push_back(b.coordinates[k]);
    rest.in_quadrature.push_back(b.in_quadrature[k]);
  }
  return rest;
}

}  // namespace

StaticCount static_count(const BlockedImpedance& h, const std::vector<Index>& free, const std::vector<Index>& cyclic, Index zeros) {
  const Lifted lifted = h.impedance.at(0.0);
  constexpr double nothing = 16;
  const double rounding = nothing * h.impedance.rounding(0);
  StaticCount s;
  Index found = 0;
  for (const Block& b : h.blocks) {
    const auto nearly_zero = [&](const BlockState& e) -> Index { return (e.eigenvalues.array().abs() <= rounding * e.size).count(); };
    const auto zero_from_above = [&](const BlockState& e) -> Index {
      return (e.eigenvalues.array().abs() <= rounding * e.size && e.eigenvalues.array() >= 0).count();
    };
    const BlockState state = state_of(b, lifted);
    const Index nearly = nearly_zero(state);
    found += nearly * b.copies();
    const Index count = state.count + zero_from_above(state);
    const Index of_free = std::count_if(b.coordinates.begin(), b.coordinates.end(), [&](Index i) { return in(free, i); });
    s.count.push_back(count);
    s.reduced.push_back(count - of_free - nearly);
    const Block fixed = without(b, cyclic);
    if (fixed.size() == 0) continue;
    const BlockState still = state_of(fixed, lifted);
    const Index free_left = std::count_if(fixed.coordinates.begin(), fixed.coordinates.end(), [&](Index i) { return in(free, i); });
    s.negative += (still.count + zero_from_above(still) - free_left - nearly_zero(still)) * b.copies();
  }
  s.doubtful = found != zeros;
  if (s.doubtful) {  // then roots are sought from a little above 0, and not called complete
    constexpr double above_zero = 1e-6;
    const Lifted beside = h.impedance.at(above_zero);
    for (std::size_t b = 0; b < h.blocks.size(); ++b) s.count[b] = state_of(h.blocks[b], beside).count;
  }
  return s;
}

}  // namespace gyromode
