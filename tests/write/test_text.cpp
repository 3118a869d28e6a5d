// What people read: digits, tables, lines.
#include "gyromode/base/lines.h"
#include "gyromode/write/digits.h"
#include "gyromode/write/grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace gyromode {
namespace {

using io::determined;

TEST(Digits, LastPlaceIsTwiceTheErrorOrMore) {
  EXPECT_EQ(determined(3.14159, 0.002), "3.14");
  EXPECT_EQ(determined(3.14159, 0.0049), "3.14");
  EXPECT_EQ(determined(3.14159, 0.0051), "3.1");
  EXPECT_EQ(determined(9.9996, 1e-3), "10.00");
  EXPECT_EQ(determined(-2, 1e-9), "-2.00000000");
  EXPECT_EQ(determined(123456, 400), "1.23e+05");
  EXPECT_EQ(determined(0.000012345, 1e-9), "1.234e-05");
  EXPECT_EQ(determined(M_PI, 0), "3.14159265358979");
  EXPECT_EQ(determined(M_PI, 1e-30, 10), "3.141592654");
  EXPECT_EQ(determined(0, 0), "0");
}

TEST(Digits, NoneAreClaimedThatAreNotKnown) {
  EXPECT_EQ(determined(0.1234, 0.5), "≈0.12");
  EXPECT_EQ(determined(0.1234, 0.1), "≈0.12");
  EXPECT_EQ(determined(0.1234, INFINITY), "≈0.12");
  EXPECT_EQ(determined(0.1234, NAN), "≈0.12");
  EXPECT_EQ(determined(1e300, 1e301), "≈1.0e+300");
}

// What is printed is within one unit of its last place of anything that the error allows.
TEST(Digits, PrintedNumberIsWithinAUnitOfItsLastPlace) {
  std::mt19937_64 source(5);
  std::uniform_real_distribution<double> exponent(-12, 12), relative(-16, -1), unit(-1, 1);
  for (int draw = 0; draw < 20000; ++draw) {
    const double value = (unit(source) < 0 ? -1 : 1) * std::pow(10, exponent(source)),
                 error = std::abs(value) * std::pow(10, relative(source));
    const std::string text = determined(value, error);
    if (text.starts_with("≈")) continue;
    std::string place = text.substr(0, text.find('e'));
    const double scale = text.find('e') == std::string::npos ? 1 : std::pow(10, std::stoi(text.substr(text.find('e') + 1)));
    const std::size_t point = place.find('.');
    const double last = scale * (point == std::string::npos ? 1 : std::pow(10, -static_cast<double>(place.size() - point - 1)));
    const double truth = value + unit(source) * error;
    EXPECT_LE(std::abs(std::stod(text) - truth), 1.0001 * last + 1e-15 * std::abs(value)) << value << " ± " << error << ": " << text;
    EXPECT_TRUE(last <= 21 * error || last <= 1.01e-14 * std::abs(value)) << value << " ± " << error << ": " << text;
  }
}

TEST(Grid, PointsMeet) {
  io::Grid grid({"#", "ω [rad/s]", "kind"});
  grid.add({"1", "0", "rigid body ×2"});
  grid.add({"10", "12.5", "vibration"});
  grid.add({"100", "3.25", "vibration"});
  EXPECT_EQ(grid.aligned(),
            "    #  ω [rad/s]  kind\n"
            "    1       0     rigid body ×2\n"
            "   10      12.5   vibration\n"
            "  100       3.25  vibration\n");
}

TEST(Grid, WideTablesGoOnBelow) {
  std::vector<std::string> heading{"#"}, row{"1"};
  for (int c = 0; c < 12; ++c) {
    heading.push_back("coordinate" + std::to_string(c));
    row.push_back("0.123456");
  }
  io::Grid grid(heading);
  grid.add(row);
  const std::string text = grid.aligned();
  std::size_t lines = 0, at = 0, longest = 0;
  for (std::size_t end; (end = text.find('\n', at)) != std::string::npos; at = end + 1, ++lines) longest = std::max(longest, end - at);
  EXPECT_LE(longest, line_columns);
  EXPECT_EQ(lines, 8U) << text;  // three panels of two lines, parted by blank ones
  EXPECT_NE(text.find("coordinate11"), std::string::npos);
}

TEST(Grid, WordsWrapWithinTheirColumn) {
  io::Grid grid({"component", "coordinates", "class"});
  grid.add({"1", "a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11, a12, a13, a14, a15, a16", "quadrature"});
  EXPECT_EQ(grid.aligned(),
            "  component  coordinates                                              class\n"
            "          1  a01, a02, a03, a04, a05, a06, a07, a08, a09, a10, a11,   quadrature\n"
            "             a12, a13, a14, a15, a16\n");
}

TEST(Markdown, LabelsAreShownAsTheyAre) {
  EXPECT_EQ(io::markdown_escaped("theta_1"), "theta_1");
  EXPECT_EQ(io::markdown_escaped("_x_*y*|z|<b>`c`$d$"), "\\_x\\_\\*y\\*\\|z\\|\\<b\\>\\`c\\`\\$d\\$");
  EXPECT_EQ(io::markdown_escaped("[a](b)"), "[a\\](b)");
  EXPECT_EQ(io::markdown_escaped("two\nlines"), "two lines");
}

TEST(Lines, CombiningMarksTakeNoColumn) {
  EXPECT_EQ(columns_of("M q̈ + K q"), 9U);
  EXPECT_EQ(columns_of("ω ≥ 0"), 5U);
  EXPECT_EQ(wrapped("one two three", 7), (std::vector<std::string>{"one two", "three"}));
  EXPECT_EQ(wrapped("unbreakable x", 5), (std::vector<std::string>{"unbreakable", "x"}));
  EXPECT_EQ(wrapped("", 5), std::vector<std::string>{""});
}

}  // namespace
}  // namespace gyromode
