#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gyromode::io {

/// A chart of curves over one axis as a picture (SVG), light on paper and dark on a dark page: a frame with ticks at
/// round numbers, curves that end at the frame, marks, and labels that neither leave the frame nor cover each other;
/// one without room is left out.
class Chart {
 public:
  struct Axis {
    std::string title;  ///< with its unit
    double from = 0, to = 1;
    bool logarithmic = false;  ///< from > 0
  };
  /// A class of curves: its name for the legend, a colour, and the dashes by which it is told in grey.
  struct Style {
    std::string name, colour, dashes;
    double width = 1.6;
    bool area = false;  ///< the legend shows a patch of the colour
  };

  Chart(std::string title, Axis x, Axis y);

  /// A curve through points in the units of the axes; not-a-number parts it.
  void curve(const std::vector<std::pair<double, double>>& points, const Style& style);
  /// A band over a part of the x axis.
  void band(double from, double to, const Style& style);
  /// A filled rectangle, and a letter in its middle where it is large enough.
  void cell(double x0, double x1, double y0, double y1, const std::string& letter, const Style& style);
  /// A mark, "circle" or "diamond". Marks come before labels, which keep off them.
  void mark(double x, double y, const std::string& shape);
  /// A label beside the place, if there is room.
  void label(double x, double y, const std::string& text);

  std::string text() const;

 private:
  struct Box {
    double left, top, right, bottom;
  };
  static double along(const Axis& axis, double value);
  double px(double x) const;
  double py(double y) const;
  void explain(const Style& style);
  bool place(double x, double y, double dx, double dy, const std::string& text);

  std::string title_;
  Axis x_, y_;
  std::vector<Style> legend_;
  std::vector<Box> taken_;
  std::string bands_, cells_, curves_, marks_, labels_;
};

/// Text as XML has it.
std::string xml_escaped(std::string_view text);
/// Round numbers from a to b, some five to eight of them; of a logarithmic axis powers of ten, or all that is round.
std::vector<double> ticks(double a, double b);
std::vector<double> ticks(const Chart::Axis& axis);
/// A range of powers of ten about values > 0, at most `decades` of them below the largest.
Chart::Axis decades(std::string title, double smallest, double largest, double most);
/// The k-th of several curves: colours that those see apart who do not see all (Okabe and Ito), and dashes for grey.
Chart::Style numbered_style(std::size_t k, std::string name);

}  // namespace gyromode::io
