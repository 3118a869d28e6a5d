#include "gyromode/write/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gyromode::io {

namespace {

// The sheet, the frame in it, and letters, in px.
namespace sheet {
constexpr double width = 900, height = 560, left = 78, top = 48, right = 720, bottom = 494, font = 12, letter = 0.62 * font;
}

// Characters, not bytes.
double length_of(const std::string& s) {
  return static_cast<double>(std::count_if(s.begin(), s.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

std::string shortened(const std::string& s, std::size_t most) {
  if (length_of(s) <= static_cast<double>(most)) return s;
  std::string out;
  std::size_t count = 0;
  for (const char c : s) {
    if ((static_cast<unsigned char>(c) & 0xC0) != 0x80 && ++count >= most) break;
    out += c;
  }
  return out + "…";
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::vector<double> ticks(double a, double b) {
  constexpr double wanted = 6;
  const double rough = (b - a) / wanted, power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double nice : {1.0, 2.0, 5.0}) {
    if (nice * power >= rough) {
      step = nice * power;
      break;
    }
  }
  std::vector<double> all;
  for (double k = std::ceil(a / step - 1e-9); k * step <= b + 1e-9 * step; ++k) all.push_back(k * step + 0.0);  // no −0
  return all;
}

std::vector<double> ticks(const Chart::Axis& a) {
  if (!a.logarithmic) return ticks(a.from, a.to);
  constexpr double slack = 1e-9, most = 9;
  const double first = std::log10(a.from), last = std::log10(a.to);
  const double step = std::max(1.0, std::ceil((last - first) / most));
  const bool few = last - first < 2;  // then 2 and 5 of every decade too
  std::vector<double> all;
  for (double k = std::floor(first); k <= last + slack; k += few ? 1 : step) {
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10, k);
      if ((digit == 1 || few) && value >= a.from * (1 - slack) && value <= a.to * (1 + slack)) all.push_back(value);
    }
  }
  return all;
}

Chart::Axis decades(std::string title, double smallest, double largest, double most) {
  if (!(largest > 0)) return {std::move(title), 0.1, 1, true};
  const double top = std::ceil(std::log10(largest) + 1e-9), bottom = std::floor(std::log10(smallest > 0 ? smallest : largest));
  return {std::move(title), std::pow(10, std::clamp(bottom, top - most, top - 1)), std::pow(10, top), true};
}

Chart::Style numbered_style(std::size_t k, std::string name) {
  constexpr std::array<std::pair<const char*, const char*>, 7> styles{{{"#0072B2", ""},
                                                                       {"#D55E00", "7 4"},
                                                                       {"#009E73", "9 3 2 3"},
                                                                       {"#CC79A7", "2 3"},
                                                                       {"#56B4E9", "12 4"},
                                                                       {"#E69F00", "5 2 1 2"},
                                                                       {"#555555", "1 2"}}};
  const auto& [colour, dashes] = styles[k % styles.size()];
  return {std::move(name), colour, dashes};
}

Chart::Chart(std::string title, Axis x, Axis y) : title_(std::move(title)), x_(std::move(x)), y_(std::move(y)) {}

// From 0 at the beginning of an axis to 1 at its end; what a logarithm has no place for is far below.
double Chart::along(const Axis& a, double value) {
  constexpr double far_below = -10;
  if (!a.logarithmic) return (value - a.from) / (a.to - a.from);
  return value > 0 ? std::max(far_below, std::log(value / a.from) / std::log(a.to / a.from)) : far_below;
}
double Chart::px(double x) const {
  using namespace sheet;
  return left + along(x_, x) * (right - left);
}
double Chart::py(double y) const {
  using namespace sheet;
  return bottom - along(y_, y) * (bottom - top);
}

void Chart::curve(const std::vector<std::pair<double, double>>& points, const Style& style) {
  std::string path;
  bool open = false;
  for (const auto& [x, y] : points) {
    if (std::isnan(x) || std::isnan(y)) {
      open = false;
      continue;
    }
    path += fmt::format("{}{:.2f} {:.2f}", open ? " L" : path.empty() ? "M" : " M", px(x), py(y));
    open = true;
  }
  if (path.empty()) return;
  curves_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"{}/>\n", path, style.colour, style.width,
                         style.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", style.dashes));
  explain(style);
}

// In the legend, once.
void Chart::explain(const Style& style) {
  const bool known = std::any_of(legend_.begin(), legend_.end(), [&](const Style& s) { return s.name == style.name; });
  if (!known && !style.name.empty()) legend_.push_back(style);
}

void Chart::band(double from, double to, const Style& style) {
  using namespace sheet;
  const double a = std::clamp(px(from), left, right), b = std::clamp(px(to), left, right);
  bands_ += fmt::format("<rect x=\"{:.2f}\" y=\"{}\" width=\"{:.2f}\" height=\"{}\" fill=\"{}\" fill-opacity=\"0.18\"/>\n", a, top,
                        std::max(b - a, 1.5), bottom - top, style.colour);
  explain(style);
}

void Chart::cell(double x0, double x1, double y0, double y1, const std::string& letter, const Style& style) {
  using namespace sheet;
  const double a = px(x0), b = px(x1), low = py(y0), high = py(y1);
  cells_ += fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" fill=\"{}\" class=\"cell\"/>\n", a, high, b - a,
                        low - high, style.colour);
  if (!letter.empty() && b - a > font && low - high > font)
    cells_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"letter\" text-anchor=\"middle\">{}</text>\n", 0.5 * (a + b),
                          0.5 * (low + high) + 4, xml_escaped(letter));
  explain(style);
}

// At (x, y) px, the text beginning there for dx > 0, ending there else.
bool Chart::place(double x, double y, double dx, double dy, const std::string& text) {
  using namespace sheet;
  const double size = letter * length_of(text), at = x + dx, line = y + dy;
  const Box box{dx > 0 ? at : at - size, line - font, dx > 0 ? at + size : at, line + 3};
  if (box.left < left + 2 || box.right > right - 2 || box.top < top + 2 || box.bottom > bottom - 2) return false;
  const bool covers = std::any_of(taken_.begin(), taken_.end(), [&](const Box& o) {
    return box.left < o.right && o.left < box.right && box.top < o.bottom && o.top < box.bottom;
  });
  if (covers) return false;
  taken_.push_back(box);
  labels_ +=
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\"{}>{}</text>\n", at, line, dx > 0 ? "" : " text-anchor=\"end\"", xml_escaped(text));
  return true;
}

void Chart::label(double x, double y, const std::string& text) {
  for (const auto& [dx, dy] : {std::pair(6.0, -6.0), {6.0, 15.0}, {-6.0, -6.0}, {-6.0, 15.0}}) {
    if (place(px(x), py(y), dx, dy, text)) return;
  }
}

void Chart::mark(double x, double y, const std::string& shape) {
  using namespace sheet;
  const double a = px(x), b = py(y);
  if (a < left || a > right || b < top || b > bottom) return;
  if (shape == "diamond")
    marks_ += fmt::format("<path d=\"M{:.1f} {:.1f} l6 6 l-6 6 l-6 -6 z\" class=\"mark\"/>\n", a, b - 6);
  else
    marks_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.6\" class=\"mark\"/>\n", a, b);
  taken_.push_back({a - 5, b - 5, a + 5, b + 5});
}

std::string Chart::text() const {
  using namespace sheet;
  constexpr std::size_t longest_title = 90;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" role=\"img\" aria-label=\"{2}\">\n"
      "<style>text{{font:{3}px sans-serif;fill:#222}}.title{{font-size:15px;font-weight:bold}}.frame{{fill:none;stroke:#444}}"
      ".grid{{stroke:#ccc;stroke-width:.7}}.mark{{fill:#fff;stroke:#222;stroke-width:1.3}}.cell{{stroke:#fff;stroke-width:.4}}"
      ".letter{{fill:#000;paint-order:stroke;stroke:#fff;stroke-width:2.5px}}"
      "@media(prefers-color-scheme:dark){{text{{fill:#ddd}}.page{{fill:#1b1d21}}.frame{{stroke:#aaa}}.grid{{stroke:#444}}"
      ".mark{{fill:#1b1d21;stroke:#ddd}}}}</style>\n"
      "<rect class=\"page\" width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n<clipPath id=\"frame\"><rect x=\"{4}\" y=\"{5}\" width=\"{6}\" "
      "height=\"{7}\"/></clipPath>\n<text class=\"title\" x=\"{4}\" y=\"28\">{8}</text>\n",
      width, height, xml_escaped(title_), font, left, top, right - left, bottom - top, xml_escaped(shortened(title_, longest_title)));
  out += "<g clip-path=\"url(#frame)\">\n" + bands_ + cells_ + "</g>\n";
  for (const double x : ticks(x_)) {
    out +=
        fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1} V{2}\"/><text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">{4:.6g}</text>\n",
                    px(x), top, bottom, bottom + 18, x);
  }
  for (const double y : ticks(y_)) {
    out += fmt::format("<path class=\"grid\" d=\"M{1} {0:.1f} H{2}\"/><text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">{5:.6g}</text>\n",
                       py(y), left, right, left - 8, py(y) + 4, y);
  }
  out += "<g clip-path=\"url(#frame)\">\n" + curves_ + "</g>\n" + marks_ + "<g class=\"labels\">\n" + labels_ + "</g>\n";
  out += fmt::format("<rect class=\"frame\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>\n", left, top, right - left, bottom - top);
  out += fmt::format("<text x=\"{:.0f}\" y=\"{}\" text-anchor=\"middle\">{}</text>\n", 0.5 * (left + right), bottom + 42,
                     xml_escaped(x_.title));
  out += fmt::format("<text transform=\"translate(20 {:.0f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", 0.5 * (top + bottom),
                     xml_escaped(y_.title));
  double y = top + 14;
  for (const Style& s : legend_) {
    if (s.area) {
      out += fmt::format(
          "<rect x=\"{}\" y=\"{:.0f}\" width=\"34\" height=\"14\" style=\"fill:{};stroke:#444\"/><text x=\"{}\" y=\"{:.0f}\">{}</text>\n",
          right + 18, y - 7, s.colour, right + 60, y + 4, xml_escaped(shortened(s.name, 18)));
      y += 22;
      continue;
    }
    out +=
        fmt::format("<path d=\"M{} {:.0f} h34\" stroke=\"{}\" stroke-width=\"{}\" fill=\"none\"{}/><text x=\"{}\" y=\"{:.0f}\">{}</text>\n",
                    right + 18, y, s.colour, s.width, s.dashes.empty() ? "" : fmt::format(" stroke-dasharray=\"{}\"", s.dashes), right + 60,
                    y + 4, xml_escaped(shortened(s.name, 15)));
    y += 22;
  }
  return out + "</svg>\n";
}

}  // namespace gyromode::io
