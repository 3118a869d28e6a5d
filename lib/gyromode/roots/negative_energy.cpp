#include "gyromode/roots/negative_energy.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace gyromode {

namespace {

struct Sample {
  double omega;
  BlockState state;
};

// A block and its states.
class Sampled {
 public:
  Sampled(const BlockedImpedance& h, Index block) : h_(h), block_(h.blocks[static_cast<std::size_t>(block)]) {}

  Sample at(double omega) const { return {omega, state_of(block_, h_.impedance.at(omega))}; }
  // Whether the count there is beyond what rounding may have made of it.
  bool certain(const Sample& s) const {
    constexpr double beyond_doubt = 16;
    return std::abs(s.state.nearest) > beyond_doubt * h_.impedance.rounding(s.omega) * s.state.size;
  }

  std::vector<Sample> certain_at(const std::vector<double>& omegas) const {
    std::vector<Sample> samples;
    for (const double omega : omegas) {
      if (Sample s = at(omega); certain(s)) samples.push_back(std::move(s));
    }
    return samples;
  }

  // Two roots of opposite signs close to each other leave no trace in counts beside them, but the eigenvalue that
  // nearly vanishes has an extremum there: of three samples over which the count stays, with the middle one nearest to
  // zero, a point between the roots, by parabolas. Nothing where the extremum does not pass zero.
  std::optional<Sample> beyond_extremum(Sample lo, Sample middle, Sample hi) const {
    constexpr int most_steps = 30;
    if (!touches(lo, middle, hi)) return std::nullopt;
    for (int step = 0; step < most_steps; ++step) {
      const double left = middle.omega - lo.omega, right = hi.omega - middle.omega;
      const double rise_left = (lo.state.nearest - middle.state.nearest) / left,
                   rise_right = (hi.state.nearest - middle.state.nearest) / right;
      const double vertex =
          middle.omega + 0.5 * (rise_left * right * right - rise_right * left * left) / (rise_left * right + rise_right * left);
      // Where the parabola stays where it is, the longer side is cut.
      const double closest = 1e-3 * (hi.omega - lo.omega);
      const double omega = std::abs(vertex - middle.omega) > closest && vertex > lo.omega && vertex < hi.omega
                               ? vertex
                               : middle.omega + (right > left ? 0.1 * right : -0.1 * left);
      Sample next = at(omega);
      if (next.state.count != middle.state.count) return certain(next) ? std::optional(std::move(next)) : std::nullopt;
      const bool nearer = std::abs(next.state.nearest)<std::abs(middle.state.nearest), above = next.omega> middle.omega;
      const double gained = std::abs(middle.state.nearest) - std::abs(next.state.nearest);
      const bool settled = nearer && gained < 1e-3 * std::abs(next.state.nearest);
      if (settled || !certain(next)) return std::nullopt;
      if (nearer) {
        (above ? lo : hi) = std::move(middle);
        middle = std::move(next);
      } else {
        (above ? hi : lo) = std::move(next);
      }
    }
    return std::nullopt;
  }

 private:
  static bool touches(const Sample& lo, const Sample& middle, const Sample& hi) {
    const double m = middle.state.nearest;
    return lo.state.count == middle.state.count && hi.state.count == middle.state.count && lo.state.nearest * m > 0 &&
           hi.state.nearest * m > 0 && std::abs(m) < std::abs(lo.state.nearest) && std::abs(m) < std::abs(hi.state.nearest);
  }

  const BlockedImpedance& h_;
  const Block& block_;
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

std::vector<Root> falls(const BlockedImpedance& h, Index block, const std::vector<double>& omegas) {
  constexpr double narrowest = 1e-12;  // relative: falls nearer than this are left
  const Sampled sampled(h, block);
  std::vector<Sample> samples = sampled.certain_at(omegas);  // a fall seen between points that rounding may count wrongly is none
  std::vector<Sample> between;
  for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
    if (auto extremum = sampled.beyond_extremum(samples[i - 1], samples[i], samples[i + 1])) between.push_back(std::move(*extremum));
  }
  samples.insert(samples.end(), std::make_move_iterator(between.begin()), std::make_move_iterator(between.end()));
  std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.omega < b.omega; });
  std::vector<Root> found;
  for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
    std::vector<std::pair<Sample, Sample>> open{{samples[i], samples[i + 1]}};
    while (!open.empty()) {
      const auto [lo, hi] = std::move(open.back());
      open.pop_back();
      const Index fall = lo.state.count - hi.state.count;
      if (fall <= 0) continue;
      if (fall == 1) {
        const Index count = lo.state.count;
        found.push_back(
            converge(h, {block, lo.omega, hi.omega, 1, count, -1, crossing(lo.state, count, -1), crossing(hi.state, count, -1)}).front());
      } else if (hi.omega - lo.omega > narrowest * hi.omega) {
        const Sample middle = sampled.at(0.5 * (lo.omega + hi.omega));
        if (!sampled.certain(middle)) continue;
        open.emplace_back(middle, hi);
        open.emplace_back(lo, middle);
      }
    }
  }
  return found;
}

}  // namespace gyromode
