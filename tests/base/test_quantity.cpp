#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"
#include "gyromode/base/quantity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gyromode::io {
namespace {

constexpr double pi = std::numbers::pi;

TEST(Frequency, EveryUnit) {
  const std::vector<std::pair<const char*, double>> factors{{"", 1},
                                                            {"rad/s", 1},
                                                            {"1/s", 1},
                                                            {"Hz", 2 * pi},
                                                            {"rev/s", 2 * pi},
                                                            {"kHz", 2000 * pi},
                                                            {"rpm", pi / 30},
                                                            {"krpm", 1000 * pi / 30},
                                                            {"deg/s", pi / 180}};
  for (const auto& [unit, factor] : factors) {
    for (const double number : {0.0, 1.0, 2.5, -7.0}) {
      for (const char* blank : {"", " ", "\t  "}) {
        if (std::string_view(unit) == "1/s" && *blank == 0) continue;  // its 1 would be a digit of the number
        const std::string text = std::to_string(number) + blank + unit;
        const auto value = parse_frequency(text);
        ASSERT_TRUE(value) << text;
        EXPECT_DOUBLE_EQ(*value, number * factor) << text;
      }
    }
  }
}

TEST(Frequency, EveryUnitNamedInMessagesIsAccepted) {
  for (std::string_view left = frequency_form.substr(frequency_form.find(": ") + 2); !left.empty();) {
    const std::size_t end = std::min(left.find(", "), left.size());
    EXPECT_TRUE(parse_frequency("1 " + std::string(left.substr(0, end)))) << left;
    left.remove_prefix(std::min(end + 2, left.size()));
  }
}

TEST(Frequency, NumbersWithSignsBlanksAndExponents) {
  EXPECT_EQ(parse_frequency("10"), 10.0);
  EXPECT_EQ(parse_frequency(" \t10\t "), 10.0);
  EXPECT_EQ(parse_frequency("-0.5"), -0.5);
  EXPECT_EQ(parse_frequency("+0.5 rad/s"), 0.5);
  EXPECT_EQ(parse_frequency(".5"), 0.5);
  EXPECT_EQ(parse_frequency("5."), 5.0);
  EXPECT_EQ(parse_frequency("5e3"), 5000.0);
  EXPECT_EQ(parse_frequency("5e3Hz"), 5000 * 2 * pi);
  EXPECT_EQ(parse_frequency("5E+3 Hz"), 5000 * 2 * pi);
  EXPECT_EQ(parse_frequency("5e-3rad/s"), 0.005);
  EXPECT_EQ(parse_frequency("2 1/s"), 2.0);
  EXPECT_EQ(parse_frequency("1e-999 Hz"), 0.0);
  EXPECT_EQ(parse_frequency("0"), 0.0);
}

TEST(Frequency, Garbage) {
  for (const char* text :
       {"",      " ",     "\t",  "Hz",   "rad/s", "fast",  "10 hz", "10 HZ",   "10 rad", "10 rad / s", "10 Hz Hz", "10 Hz 3", "10 10",
        "1.2.3", "--1",   "+-1", "-+1",  "- 1",   "+",     "-",     ".",       "e",      "e3",         "5e",       "5eHz",    "5e+",
        "5 e3",  "5e3e3", "1-2", "0x10", "1,5",   "1_000", "10\n",  "10 Hz\n", "10 µHz", "½ Hz",       "1D3 Hz",   "3 eV",    "10%"}) {
    EXPECT_FALSE(parse_frequency(text)) << "'" << text << "'";
  }
  EXPECT_FALSE(parse_frequency(std::string_view("1\0", 2)));
  EXPECT_FALSE(parse_frequency(std::string_view("1 Hz\0", 5)));
}

TEST(Frequency, IsFiniteAlways) {
  for (const char* text :
       {"inf", "-inf", "infinity", "+inf Hz", "nan", "NaN rad/s", "-nan", "1e999", "-1e999 rpm", "1e308 Hz", "1.7e308 kHz", "1e308krpm"}) {
    EXPECT_FALSE(parse_frequency(text)) << text;
  }
  EXPECT_EQ(parse_frequency("1.7e308"), 1.7e308);
  EXPECT_TRUE(parse_frequency("1e308 rpm"));
}

TEST(Nearest, FewestEdits) {
  constexpr std::array<std::string_view, 4> words{"mass", "gyroscopic", "stiffness", "stiffness_per_spin2"};
  const auto of = [&](std::string_view word) { return nearest(word, words); };
  EXPECT_EQ(of("mass"), "mass");
  EXPECT_EQ(of("stifness"), "stiffness");     // one missing
  EXPECT_EQ(of("stiffnesss"), "stiffness");   // one too many
  EXPECT_EQ(of("gyroscobic"), "gyroscopic");  // one replaced
  EXPECT_EQ(of("sitffness"), "stiffness");    // two swapped
  EXPECT_EQ(of("stiffness_per_spin"), "stiffness_per_spin2");
  EXPECT_EQ(of(""), "mass");
  EXPECT_EQ(of(std::string(100'000, 'x')).empty(), false);
}

TEST(Nearest, ASwapIsOneEdit) {
  constexpr std::array<std::string_view, 2> words{"abXY", "ba"};
  EXPECT_EQ(nearest("ab", words), "ba");
  constexpr std::array<std::string_view, 2> as_near{"ac", "ba"};  // the first of those as near
  EXPECT_EQ(nearest("ab", as_near), "ac");
}

TEST(Nearest, OfNothing) { EXPECT_EQ(nearest("word", {}), ""); }

TEST(Real, Numbers) {
  const std::vector<std::pair<const char*, double>> all{{"0", 0},
                                                        {"1", 1},
                                                        {"-1", -1},
                                                        {"+1", 1},
                                                        {"007", 7},
                                                        {".5", .5},
                                                        {"5.", 5},
                                                        {"-.5e1", -5},
                                                        {"1e3", 1e3},
                                                        {"1E3", 1e3},
                                                        {"1.0D+03", 1e3},
                                                        {"1.0d-03", 1e-3},
                                                        {"+2.5D0", 2.5},
                                                        {"-1D2", -1e2},
                                                        {"0.1", 0.1},
                                                        {"4.9e-324", 4.9e-324},
                                                        {"1.7976931348623157e308", std::numeric_limits<double>::max()}};
  for (const auto& [word, value] : all) {
    const Parsed p = parse_real(word);
    EXPECT_EQ(p.outcome, Parsed::ok) << word;
    EXPECT_EQ(p.value, value) << word;
  }
}

TEST(Real, TooSmallIsZeroAndTooLargeIsNotFinite) {
  for (const char* word : {"1e-999", "-1e-999", "1D-999", "0.0001e-400", "123456e-999", "1e-99999999999999999999", "+1e-400"}) {
    const Parsed p = parse_real(word);
    EXPECT_EQ(p.outcome, Parsed::ok) << word;
    EXPECT_EQ(p.value, 0) << word;
  }
  const std::string tiny = "0." + std::string(400, '0') + "1";
  EXPECT_EQ(parse_real(tiny).outcome, Parsed::ok);
  EXPECT_EQ(parse_real(tiny).value, 0);
  EXPECT_EQ(parse_real(tiny + "e401").outcome, Parsed::ok);
  EXPECT_DOUBLE_EQ(parse_real(tiny + "e401").value, 1);
  for (const char* word : {"1e999", "-1e999", "1D999", "+1e309", "1.8e308", "1e99999999999999999999", "inf", "-inf", "+inf", "infinity",
                           "INF", "nan", "NaN", "-nan"}) {
    EXPECT_EQ(parse_real(word).outcome, Parsed::not_finite) << word;
  }
  EXPECT_EQ(parse_real(std::string(400, '9')).outcome, Parsed::not_finite);
  EXPECT_EQ(parse_real("0e999").outcome, Parsed::ok);
}

TEST(Real, Garbage) {
  for (const char* word : {"",      "+",  "-",  "--1",   "++1", "+-1",  "-+1", "e3",  "1e", "1e+",   "1D",  "D3", "1D2D3",
                           "1e2D3", "1 ", " 1", "1.2.3", "1,5", "0x10", "1f",  "one", ".",  "1e3.5", "1_0", "١"}) {
    EXPECT_EQ(parse_real(word).outcome, Parsed::not_a_number) << "'" << word << "'";
  }
  EXPECT_EQ(parse_real(std::string_view("1\0", 2)).outcome, Parsed::not_a_number);
}

TEST(WholeNumber, Edges) {
  EXPECT_EQ(whole_number("0"), 0);
  EXPECT_EQ(whole_number("-0"), 0);
  EXPECT_EQ(whole_number("+12"), 12);
  EXPECT_EQ(whole_number("-12"), -12);
  EXPECT_EQ(whole_number("0012"), 12);
  EXPECT_EQ(whole_number("9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(whole_number("-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  for (const char* word : {"",
                           "+",
                           "-",
                           "--1",
                           "++1",
                           "+-1",
                           "-+1",
                           "1.0",
                           "1.",
                           "1e3",
                           "1D3",
                           " 1",
                           "1 ",
                           "0x10",
                           "9223372036854775808",
                           "-9223372036854775809",
                           "1e999",
                           "1e-999",
                           "one",
                           "inf",
                           "nan"}) {
    EXPECT_FALSE(whole_number(word)) << "'" << word << "'";
  }
}

}  // namespace
}  // namespace gyromode::io
