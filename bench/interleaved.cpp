#include "interleaved.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace gyromode::bench {

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  const double place = q * static_cast<double>(values.size() - 1);
  const std::size_t below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], place - std::floor(place));
}

double Timing::median() const { return quantile(seconds, 0.5); }
double Timing::spread() const { return (quantile(seconds, 0.75) - quantile(seconds, 0.25)) / median(); }

Ratio ratio(const Timing& numerator, const Timing& denominator) {
  Ratio r{numerator.median() / denominator.median(), std::numeric_limits<double>::infinity(), 0};
  for (std::size_t i = 0; i < numerator.seconds.size(); ++i) {
    const double here = numerator.seconds[i] / denominator.seconds[i];
    r.lowest = std::min(r.lowest, here);
    r.highest = std::max(r.highest, here);
  }
  return r;
}

std::vector<Timing> interleaved(const std::vector<Contestant>& contestants, int rounds) {
  using Clock = std::chrono::steady_clock;
  std::vector<Timing> timings;
  for (const Contestant& c : contestants) timings.push_back({c.name, c.options, {}});
  for (int round = 0; round <= rounds; ++round) {
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      if (contestants[i].prepare) contestants[i].prepare();
      const auto start = Clock::now();
      contestants[i].run();
      const std::chrono::duration<double> elapsed = Clock::now() - start;
      if (round > 0) timings[i].seconds.push_back(elapsed.count());
    }
  }
  return timings;
}

}  // namespace gyromode::bench
