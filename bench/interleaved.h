#pragma once

#include <functional>
#include <string>
#include <vector>

namespace gyromode::bench {

/// One way to do the work. `prepare` is not timed (copies of inputs that LAPACK overwrites), `run` is.
struct Contestant {
  std::string name;
  std::string options;  ///< what a reader needs to repeat the call
  std::function<void()> prepare;
  std::function<void()> run;
};

/// Wall-clock seconds of one contestant, in the order of the rounds.
struct Timing {
  std::string name;
  std::string options;
  std::vector<double> seconds;

  double median() const;
  /// Distance of the quartiles relative to the median.
  double spread() const;
};

/// Ratio of the medians of two contestants of the same run, and the range of the ratios round by round.
struct Ratio {
  double of_medians = 0;
  double lowest = 0;
  double highest = 0;
};
Ratio ratio(const Timing& numerator, const Timing& denominator);

/// A B C A B C …: one round to warm up, then `rounds` timed ones, so that drift of the machine meets all contestants
/// alike.
std::vector<Timing> interleaved(const std::vector<Contestant>& contestants, int rounds);

/// The value below which a fraction q of the values lies, linear between neighbours.
double quantile(std::vector<double> values, double q);

}  // namespace gyromode::bench
