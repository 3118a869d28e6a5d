#include "gyromode/io/unit.h"

#include "gyromode/io/number.h"

#include <array>
#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

struct Unit {
  std::string_view name;
  double si;
};

constexpr double pi = std::numbers::pi;
constexpr std::array<Unit, 9> frequency_units{{{"", 1},
                                               {"rad/s", 1},
                                               {"Hz", 2 * pi},
                                               {"kHz", 2000 * pi},
                                               {"rpm", pi / 30},
                                               {"krpm", 1000 * pi / 30},
                                               {"rev/s", 2 * pi},
                                               {"1/s", 1},
                                               {"deg/s", pi / 180}}};

std::string_view trimmed(std::string_view s) {
  constexpr std::string_view blanks = " \t";
  s.remove_prefix(std::min(s.find_first_not_of(blanks), s.size()));
  return s.substr(0, s.find_last_not_of(blanks) + 1);
}

// The length of the leading number, where 'e' belongs to it only before a digit or a sign ("5e3 Hz", but "3 eV" would be a unit).
std::size_t number_length(std::string_view s) {
  std::size_t k = 0;
  while (k < s.size()) {
    const char c = s[k];
    const bool exponent = (c == 'e' || c == 'E') && k > 0 && k + 1 < s.size() && (std::string_view("+-0123456789").find(s[k + 1]) != std::string_view::npos);
    const bool sign = (c == '+' || c == '-') && (k == 0 || s[k - 1] == 'e' || s[k - 1] == 'E');
    if (!exponent && !sign && c != '.' && !(c >= '0' && c <= '9')) break;
    ++k;
  }
  return k;
}

}  // namespace

std::optional<double> parse_frequency(std::string_view text) {
  const std::string_view s = trimmed(text);
  const std::size_t length = number_length(s);
  const Parsed number = parse_real(s.substr(0, length));
  if (number.outcome != Parsed::ok) return std::nullopt;
  const std::string_view name = trimmed(s.substr(length));
  for (const Unit& unit : frequency_units) {
    if (unit.name == name) {
      const double value = number.value * unit.si;
      return std::isfinite(value) ? std::optional(value) : std::nullopt;
    }
  }
  return std::nullopt;
}

}  // namespace gyromode::io
