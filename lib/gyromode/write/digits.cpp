#include "gyromode/write/digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::io {

namespace {

// The decimal place of the first digit of |x| > 0: 0 for 3.1, −2 for 0.05; as it is after rounding to `digits`.
int leading_place(double x, int digits) {
  const std::string text = fmt::format("{:.{}e}", std::abs(x), digits - 1);
  return std::stoi(text.substr(text.find('e') + 1));
}

// Fixed notation in the middle, else with an exponent.
std::string with_digits(double value, int digits) {
  const int place = leading_place(value, digits), decimals = digits - 1 - place;
  if (place < -4 || decimals < 0) return fmt::format("{:.{}e}", value, digits - 1);
  return fmt::format("{:.{}f}", value, decimals);
}

}  // namespace

std::string determined(double value, double error, int most) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  if (value == 0) return "0";
  constexpr int at_least = 2;
  if (!(error < std::abs(value))) return "≈" + with_digits(value, at_least);
  if (error <= 0) return with_digits(value, most);
  const int last = static_cast<int>(std::ceil(std::log10(2 * error)));
  const int digits = leading_place(value, most) - last + 1;
  if (digits >= 1 && digits < most && leading_place(value, digits) > leading_place(value, most))
    return with_digits(std::stod(fmt::format("{:.{}e}", value, digits - 1)), digits + 1);  // 9.9996 to two decimals is 10.00
  return digits < 1 ? "≈" + with_digits(value, at_least) : with_digits(value, std::min(digits, most));
}

}  // namespace gyromode::io
