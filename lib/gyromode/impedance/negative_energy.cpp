#include "gyromode/impedance/negative_energy.h"

namespace gyromode {

namespace {

struct Sample {
  double omega;
  BlockState state;
};

}  // namespace

std::vector<Root> falls(const BlockedImpedance& h, Index block) {
  constexpr double slowest = 1e-9, fastest = 50;  // ω: below the first K is singular to rounding; negative energy is a slow motion
  constexpr double ratio = 1.15;
  constexpr double narrowest = 1e-12;  // relative: falls nearer than this are left
  const Block& b = h.blocks[static_cast<std::size_t>(block)];
  const auto sample = [&](double omega) { return Sample{omega, state_of(b, h.impedance.at(omega))}; };
  std::vector<Root> found;
  Sample before = sample(slowest);
  for (double omega = slowest * ratio; omega < fastest; omega *= ratio) {
    Sample after = sample(omega);
    std::vector<std::pair<Sample, Sample>> open{{before, after}};
    while (!open.empty()) {
      const auto [lo, hi] = std::move(open.back());
      open.pop_back();
      const Index fall = lo.state.count - hi.state.count;
      if (fall <= 0) continue;
      if (fall == 1) {
        const Index count = lo.state.count;
        found.push_back(converge(h, {block, lo.omega, hi.omega, 1, count, -1, crossing(lo.state, count, -1), crossing(hi.state, count, -1)}).front());
      } else if (hi.omega - lo.omega > narrowest * hi.omega) {
        const Sample middle = sample(0.5 * (lo.omega + hi.omega));
        open.emplace_back(middle, hi);
        open.emplace_back(lo, middle);
      }
    }
    before = std::move(after);
  }
  return found;
}

}  // namespace gyromode
