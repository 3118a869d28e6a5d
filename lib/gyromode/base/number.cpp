#include "gyromode/base/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

namespace gyromode {

namespace {

std::string_view without_plus(std::string_view word) { return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word; }

// Of a decimal number that no double holds: whether it is below 1, so too small rather than too large.
bool is_below_one(std::string_view number) {
  const std::size_t e = std::min(number.find_first_of("eE"), number.size());
  const std::string_view mantissa = number.substr(0, e);
  const auto point = static_cast<double>(std::min(mantissa.find('.'), e));
  const auto first = static_cast<double>(std::min(mantissa.find_first_of("123456789"), e));
  double exponent = 0;
  for (const char c : number.substr(e)) {
    if (c >= '0' && c <= '9') exponent = std::min(10 * exponent + (c - '0'), 1e15);
  }
  if (number.substr(e).find('-') != std::string_view::npos) exponent = -exponent;
  return point - first + exponent < 0;
}

}  // namespace

std::optional<std::int64_t> whole_number(std::string_view word) {
  word = without_plus(word);
  std::int64_t value = 0;
  const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || stop != word.data() + word.size()) return std::nullopt;
  return value;
}

Parsed parse_real(std::string_view word) {
  std::string_view number = without_plus(word);
  std::string with_e;
  if (number.find_first_of("dD") != std::string_view::npos) {  // Fortran's 1.0D+03
    with_e = number;
    std::replace_if(
        with_e.begin(), with_e.end(), [](char c) { return c == 'd' || c == 'D'; }, 'e');
    number = with_e;
  }
  double value = 0;
  const auto [stop, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error == std::errc::invalid_argument || stop != number.data() + number.size()) return {Parsed::not_a_number, 0};
  if (error == std::errc::result_out_of_range && is_below_one(number)) return {Parsed::ok, 0};
  if (error != std::errc{} || !std::isfinite(value)) return {Parsed::not_finite, 0};
  return {Parsed::ok, value};
}

}  // namespace gyromode
