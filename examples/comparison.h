#pragma once

#include <cmath>
#include <cstdio>
#include <string>

/// Every number that an example prints stands beside a second way to it, a closed form or another method, and is
/// compared with it there and then.
class Comparison {
 public:
  /// Promises |value − other| ≤ relative · |other|; NaN fails. Prints both and their relative difference.
  void equal(const std::string& what, double value, double other, double relative) {
    const double difference = value == other ? 0 : std::abs(value - other) / std::abs(other);
    std::printf("%20.13g %20.13g %9.1e  %s\n", value, other, difference, what.c_str());
    if (!(difference <= relative)) std::printf("%20s the two differ by more than %g\n", "DOES NOT HOLD:", relative), all_hold_ = false;
  }
  /// Promises 0 ≤ value ≤ bound.
  void at_most(const std::string& what, double value, double bound) {
    std::printf("%51.1e  %s\n", value, what.c_str());
    if (!(value >= 0 && value <= bound)) std::printf("%20s this is above %g\n", "DOES NOT HOLD:", bound), all_hold_ = false;
  }
  void holds(const std::string& what, bool so) {
    std::printf("%51s  %s\n", so ? "yes" : "no", what.c_str());
    if (!so) std::printf("%20s this had to be so\n", "DOES NOT HOLD:"), all_hold_ = false;
  }
  /// For main() to return: 1 where something did not hold.
  int exit_code() const { return all_hold_ ? 0 : 1; }

 private:
  bool all_hold_ = true;
};
