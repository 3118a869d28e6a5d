#include "gyromode/impedance/negative_energy.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode {

namespace {

struct Sample {
  double omega;
  BlockState state;
};

}  // namespace

std::vector<double> samples_of_all_decades() {
  constexpr double slowest = 1e-9, fastest = 50;  // below the first K is singular to rounding; negative energy is a slow motion
  constexpr double ratio = 1.15;
  std::vector<double> samples;
  for (double omega = slowest; omega < fastest; omega *= ratio) samples.push_back(omega);
  return samples;
}

// Denser towards ω, and evenly for roots of both signs close to each other.
std::vector<double> samples_around(double omega) {
  constexpr double widest = 0.03, narrowest = 1e-10;
  constexpr int evenly = 32;
  std::vector<double> samples;
  for (const double side : {-1.0, 1.0}) {
    for (double width = narrowest; width < widest; width *= 3) samples.push_back(omega * (1 + side * width));
    for (int k = 1; k <= evenly; ++k) samples.push_back(omega * (1 + side * widest * k / evenly));
  }
  std::sort(samples.begin(), samples.end());
  return samples;
}

std::vector<Root> falls(const BlockedImpedance& h, Index block, const std::vector<double>& samples) {
  constexpr double narrowest = 1e-12;  // relative: falls nearer than this are left
  constexpr double beyond_doubt = 16;
  const Block& b = h.blocks[static_cast<std::size_t>(block)];
  const auto sample = [&](double omega) { return Sample{omega, state_of(b, h.impedance.at(omega))}; };
  const auto certain = [&](const Sample& s) { return std::abs(s.state.nearest) > beyond_doubt * h.impedance.rounding(s.omega) * s.state.size; };
  std::vector<Root> found;
  std::optional<Sample> last;
  for (const double omega : samples) {
    Sample after = sample(omega);
    if (!certain(after)) continue;  // a fall seen between points that rounding may count wrongly is none
    if (!last) {
      last = std::move(after);
      continue;
    }
    const Sample& before = *last;
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
        if (!certain(middle)) continue;
        open.emplace_back(middle, hi);
        open.emplace_back(lo, middle);
      }
    }
    last = std::move(after);
  }
  return found;
}

}  // namespace gyromode
