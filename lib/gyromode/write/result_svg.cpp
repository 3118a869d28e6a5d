#include "gyromode/write/result_svg.h"

#include "gyromode/write/chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

constexpr double view_width = 420, view_height = 300, caption = 46, margin = 24, gap = 20;

// Onto which axes a view looks, and how far the picture reaches there.
struct View {
  Index horizontal, vertical;
  std::string_view name;
};
constexpr View above{0, 1, "from above (axes 1, 2)"};

double reach_of(const ModesResult& r) {
  double reach = 0;
  for (const ModelOutline& line : r.outlines) {
    for (const Eigen::Vector3d& p : line.points) reach = std::max(reach, p.cwiseAbs().maxCoeff());
  }
  return reach > 0 ? reach : 1;
}

// The side view shows the axis along which more wire lies.
View side_of(const ModesResult& r) {
  double along[2] = {0, 0};
  for (const ModelOutline& line : r.outlines) {
    for (int axis = 0; axis < 2; ++axis) along[axis] = std::max(along[axis], std::abs(line.points.back()(axis)));
  }
  return along[0] > along[1] ? View{0, 2, "from the side (axes 1, 3)"} : View{1, 2, "from the side (axes 2, 3)"};
}

double largest_displacement(const Mode& m) {
  double largest = 0;
  for (const ComplexMatrix& line : m.field) largest = std::max(largest, line.cwiseAbs().maxCoeff());
  return largest;
}

class Frame {
 public:
  Frame(const View& view, double left, double top, double reach)
      : view_(view), x_(left + 0.5 * view_width), y_(top + 0.5 * view_height), scale_((0.5 * view_height - margin) / reach) {
    // Wide rather than high: what lies across the picture may use its width.
    if (view.vertical == 2) scale_ = (0.5 * view_width - margin) / reach;
  }

  std::string line(const std::vector<Eigen::Vector3d>& points, std::string_view style) const {
    if (points.size() == 1) {
      return fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\" class=\"{} mass\"/>\n", x(points[0]), y(points[0]), style);
    }
    std::string at;
    for (const Eigen::Vector3d& p : points) at += fmt::format("{:.2f},{:.2f} ", x(p), y(p));
    return fmt::format("<polyline points=\"{}\" class=\"{}\"/>\n", at, style);
  }
  std::string body() const {
    return view_.vertical == 2
               ? fmt::format("<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"14\" height=\"10\" class=\"body\"/>\n", x_ - 7, y_ - 5)
               : fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"7\" class=\"body\"/>\n", x_, y_);
  }

 private:
  double x(const Eigen::Vector3d& p) const { return x_ + scale_ * p(view_.horizontal); }
  double y(const Eigen::Vector3d& p) const { return y_ - scale_ * p(view_.vertical); }

  View view_;
  double x_, y_, scale_;
};

// Places at the phase e^{jτ}.
std::vector<Eigen::Vector3d> moved(const ModelOutline& line, const ComplexMatrix& field, double size, const Complex& phase) {
  std::vector<Eigen::Vector3d> points = line.points;
  for (std::size_t k = 0; k < points.size(); ++k) points[k] += size * (field.col(static_cast<Index>(k)) * phase).real();
  return points;
}

std::string drawn(const ModesResult& r, const Mode& m, const View& view, double left, double top) {
  constexpr double shown = 0.22;  // largest displacement in the picture, of the reach
  const double reach = reach_of(r);
  const double largest = largest_displacement(m);
  const double size = largest > 0 ? shown * reach / largest : 0;
  const Frame frame(view, left, top, reach);
  std::string out = fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"frame\"/>\n", left, top,
                                view_width, view_height);
  out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" class=\"note\">{}</text>\n", left + 8, top + 16, view.name);
  for (std::size_t i = 0; i < r.outlines.size(); ++i) {
    out += frame.line(r.outlines[i].points, "rest");
    out += frame.line(moved(r.outlines[i], m.field[i], size, Complex(0, 1)), "quarter");
    out += frame.line(moved(r.outlines[i], m.field[i], size, 1), "now");
  }
  return out + frame.body();
}

}  // namespace

std::string modes_svg(const Model& model, const ModesResult& r) {
  std::vector<const Mode*> pictured;
  for (const Mode& m : r.modes) {
    if (!m.field.empty() && largest_displacement(m) > 0) pictured.push_back(&m);
  }
  const View side = side_of(r);
  const double width = 2 * view_width + 3 * gap;
  const double row = view_height + caption;
  const double head = 70;
  const double height = head + row * static_cast<double>(pictured.size()) + gap;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\">\n", width, height);
  out +=
      "<style>text{font-family:Helvetica,Arial,sans-serif;fill:#222}.title{font-size:20px;font-weight:bold}.caption{font-size:15px}.note{"
      "font-size:12px;fill:#777}"
      "polyline{fill:none;stroke-width:2;stroke-linejoin:round}.rest{stroke:#bbb;stroke-width:1.2;fill:none}.now{stroke:#1f5fa8;fill:none}."
      "quarter{stroke:#d9822b;fill:none}"
      ".mass.now{fill:#1f5fa8}.mass.quarter{fill:#d9822b}.body{fill:#444}.frame{fill:#fff;stroke:#ddd}</style>\n";
  out += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n", width, height);
  out += fmt::format("<text x=\"{:.0f}\" y=\"30\" class=\"title\">{}</text>\n", gap, xml_escaped(model.title));
  out += fmt::format(
      "<text x=\"{:.0f}\" y=\"52\" class=\"note\">axes that turn with the body; <tspan fill=\"#1f5fa8\">blue: t = 0</tspan>, <tspan "
      "fill=\"#d9822b\">orange: a quarter of a period later</tspan>, grey: at rest; "
      "sizes of the motions are not to scale</text>\n",
      gap);
  double top = head;
  for (const Mode* m : pictured) {
    const auto number = m - r.modes.data() + 1;
    const std::string kind = m->kind == ModeKind::vibration ? ""
                             : m->kind == ModeKind::local   ? " — booms alone, the body rests"
                                                            : " — tilt of the momentum axis, rigid";
    out += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" class=\"caption\">mode {}:  ω = {:.8g} rad/s,  {:.6g} Hz{}</text>\n", gap, top + 20,
                       number, m->omega, m->omega / (2 * std::numbers::pi), kind);
    out += drawn(r, *m, above, gap, top + 30);
    out += drawn(r, *m, side, 2 * gap + view_width, top + 30);
    top += row;
  }
  return out + "</svg>\n";
}

}  // namespace gyromode::io
