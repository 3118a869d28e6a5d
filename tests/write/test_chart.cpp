// Charts: labels keep off each other and inside the frame, curves are where their points are, and nothing in a title
// runs.
#include "gyromode/models/model.h"
#include "gyromode/read/read_model.h"
#include "gyromode/write/chart.h"
#include "gyromode/write/document.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <regex>
#include <string>

namespace gyromode {
namespace {

const std::filesystem::path models = std::filesystem::path(GYROMODE_SOURCE_DIR) / "models";

struct Label {
  double left, right, line;
};

// Labels of marks: 12 px text.
std::vector<Label> labels_of(const std::string& svg) {
  std::vector<Label> all;
  const std::size_t from = svg.find("<g class=\"labels\">"), to = svg.find("</g>", from);
  const std::string part = svg.substr(from, to - from);
  const std::regex text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\"( text-anchor=\"end\")?>([^<]*)</text>");
  for (auto it = std::sregex_iterator(part.begin(), part.end(), text); it != std::sregex_iterator(); ++it) {
    const double x = std::stod((*it)[1]), size = 0.62 * 12 * static_cast<double>((*it)[4].length());
    const bool end = (*it)[3].matched;
    all.push_back({end ? x - size : x, end ? x : x + size, std::stod((*it)[2])});
  }
  return all;
}

std::string diagram(const char* name, const Layout& layout) {
  const Model model = read_model(models / "rotors" / name);
  CampbellOptions o;
  for (int k = 0; k <= 40; ++k) o.spins.push_back(1600.0 * k / 40);
  o.lowest = 8;
  o.orders = {0.5, 1, 2};
  return document(model, model.campbell(o), {}, layout);
}

TEST(Chart, LabelsKeepOffEachOtherAndInsideTheFrame) {
  Layout layout(Format::svg);
  layout.spin_unit = FrequencyUnit::rpm;
  for (const char* name : {"two_discs.toml", "two_discs_orthotropic.toml", "overhung_disc.toml", "twin_spool.toml"}) {
    const std::vector<Label> labels = labels_of(diagram(name, layout));
    EXPECT_GT(labels.size(), 3U) << name;
    for (std::size_t i = 0; i < labels.size(); ++i) {
      EXPECT_GE(labels[i].left, 78);
      EXPECT_LE(labels[i].right, 720);
      for (std::size_t k = 0; k < i; ++k) {
        const bool apart =
            labels[i].right <= labels[k].left || labels[k].right <= labels[i].left || std::abs(labels[i].line - labels[k].line) >= 12;
        EXPECT_TRUE(apart) << name << " " << i << " " << k;
      }
    }
  }
}

TEST(Chart, CurvesAreWhereTheirPointsAre) {
  io::Chart chart("t", {"x", 0, 10}, {"y", 0, 4});
  chart.curve({{0, 0}, {10, 4}, {std::nan(""), 0}, {5, 2}, {10, 2}}, {"a", "#000", ""});
  EXPECT_NE(chart.text().find("M78.00 494.00 L720.00 48.00 M399.00 271.00 L720.00 271.00"), std::string::npos) << chart.text();
}

TEST(Chart, NothingInATitleRuns) {
  io::Chart chart("</script><img src=x onerror=alert(1)> \"&\"", {"x", 0, 1}, {"y", 0, 1});
  EXPECT_EQ(chart.text().find("<img"), std::string::npos);
  EXPECT_NE(chart.text().find("&lt;img"), std::string::npos);
}

TEST(Chart, TicksAreRound) {
  EXPECT_EQ(io::ticks(0, 10), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(io::ticks(0, 16000).size(), 4U);
  EXPECT_FALSE(std::signbit(io::ticks(0, 3).front()));
  EXPECT_EQ(io::ticks(-1, 1).size(), 5U);
}

}  // namespace
}  // namespace gyromode
