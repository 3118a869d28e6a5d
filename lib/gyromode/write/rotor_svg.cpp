#include "gyromode/write/rotor_svg.h"

#include "gyromode/write/chart.h"
#include "gyromode/write/digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

// A panel, px.
namespace panel {
constexpr double width = 430, height = 210, caption = 30, gap = 18, margin = 46, head = 84;
constexpr int columns = 2;
}  // namespace panel

constexpr double deflection = 46;  // px, of the largest displacement
constexpr Index places_shown = 9;  // orbits along a shaft

using Point3 = Eigen::Vector3d;

double largest_motion(const Mode& m) {
  double largest = 0;
  for (const ComplexMatrix& line : m.field) largest = std::max(largest, line.cwiseAbs().maxCoeff());
  return largest;
}

// z to the right, x upwards, y towards the viewer: obliquely to the left and down.
class Oblique {
 public:
  Oblique(const ModesResult& r, double left, double top) : left_(left), middle_(top + 0.5 * panel::height) {
    from_ = std::numeric_limits<double>::infinity();
    double to = -from_;
    for (const ModelOutline& o : r.outlines) {
      for (const Point3& p : o.points) {
        from_ = std::min(from_, p(2));
        to = std::max(to, p(2));
      }
    }
    scale_ = to > from_ ? (panel::width - 2 * panel::margin) / (to - from_) : 1;
  }
  // At rest at `at`, displaced by u, in px across the axis.
  std::string operator()(const Point3& at, const Point3& across) const {
    constexpr double right = -0.42, down = 0.30;
    return fmt::format("{:.1f},{:.1f} ", left_ + panel::margin + (at(2) - from_) * scale_ + right * across(1),
                       middle_ - across(0) + down * across(1));
  }
  double scale() const { return scale_; }

 private:
  double left_, middle_, from_ = 0, scale_ = 1;
};

// px of a displacement of 1, and of a radius.
struct Sizes {
  double displacement, radius;
};

std::string polyline(const std::string& points, const std::string& style) {
  return fmt::format("<polyline points=\"{}\" class=\"{}\"/>\n", points, style);
}

// A shaft or a disc at the phase e^{jτ}; with size 0 at rest.
std::string line(const ModelOutline& o, const ComplexMatrix& u, const Complex& phase, const Oblique& view, const Sizes& s,
                 const char* style) {
  std::string at;
  for (std::size_t k = 0; k < o.points.size(); ++k) {
    const Point3 moved = (u.col(static_cast<Index>(k)) * phase).real() * s.displacement;
    Point3 rest = o.points[k];
    Point3 across(s.radius * rest(0) + moved(0), s.radius * rest(1) + moved(1), 0);
    rest(2) += moved(2) / view.scale();
    at += view(rest, across);
  }
  return polyline(at, style);
}

std::string orbit(const Point3& at, const Eigen::Vector3cd& u, const Oblique& view, const Sizes& s) {
  constexpr int steps = 48;
  const double area = -std::imag(std::conj(u(0)) * u(1)), size = u.squaredNorm();
  const char* way = std::abs(area) <= 1e-6 * size ? "flat" : area > 0 ? "forward" : "backward";
  std::string points;
  for (int k = 0; k <= steps; ++k) {
    const Complex phase = std::polar(1.0, 2 * std::numbers::pi * k / steps);
    points += view(at, Point3((u(0) * phase).real(), (u(1) * phase).real(), 0) * s.displacement);
  }
  return polyline(points, std::string("orbit ") + way);
}

std::string drawn(const ModesResult& r, const Mode& m, double left, double top) {
  const Oblique view(r, left, top);
  double widest = 0;
  for (const ModelOutline& o : r.outlines) {
    for (const Point3& p : o.points) widest = std::max(widest, std::abs(p(0)));
  }
  constexpr double tallest = 40;  // px, of the radius of a disc
  const Sizes sizes{deflection / largest_motion(m), widest > 0 ? std::min(view.scale(), tallest / widest) : 1};
  std::string out = fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"{:.0f}\" height=\"{:.0f}\" class=\"frame\"/>\n", left, top,
                                panel::width, panel::height);
  const Complex now(1), later(0, 1), rest(0);
  for (std::size_t i = 0; i < r.outlines.size(); ++i) {
    const ModelOutline& o = r.outlines[i];
    if (o.points.size() == 1) {  // a bearing, below the shaft at rest
      out += polyline(view(o.points[0], Point3(0, 0, 0)) + view(o.points[0] + Point3(0, 0, 7 / view.scale()), Point3(-13, 0, 0)) +
                          view(o.points[0] - Point3(0, 0, 7 / view.scale()), Point3(-13, 0, 0)) + view(o.points[0], Point3(0, 0, 0)),
                      "bearing");
      continue;
    }
    out += line(o, m.field[i], rest, view, sizes, "rest");
    out += line(o, m.field[i], later, view, sizes, o.points.size() == 2 ? "quarter disc" : "quarter");
    out += line(o, m.field[i], now, view, sizes, o.points.size() == 2 ? "now disc" : "now");
    if (o.points.size() == 2) continue;
    const auto last = static_cast<Index>(o.points.size()) - 1;
    for (Index p = 0; p < places_shown; ++p) {
      const Index k = p * last / (places_shown - 1);
      out += orbit(o.points[static_cast<std::size_t>(k)], m.field[i].col(k), view, sizes);
    }
  }
  return out;
}

std::string words(const ModesResult& r, const ModeDetails& d, std::size_t k, const Layout& l) {
  const Mode& m = r.modes[k];
  std::string text =
      fmt::format("mode {}: {} {}", k + 1, determined(in_unit(m.omega, l.unit), in_unit(m.error_bound, l.unit), 7), to_string(l.unit));
  if (k < d.whirl.size() && d.whirl[k]) text += fmt::format(", {}", to_string(*d.whirl[k]));
  if (k < d.energy_shares.size() && !d.energy_shares[k].empty()) {
    const auto& shares = d.energy_shares[k];
    const auto most = std::max_element(shares.begin(), shares.end(), [](const auto& a, const auto& b) { return a.kinetic < b.kinetic; });
    text += fmt::format(", {} {:.0f} %", most->part, 100 * most->kinetic);
  }
  return text;
}

}  // namespace

bool is_of_shafts(const ModesResult& r) {
  return !r.outlines.empty() && std::all_of(r.outlines.front().points.begin(), r.outlines.front().points.end(), [](const Point3& p) {
    return p(0) == 0 && p(1) == 0;
  }) && r.outlines.front().name.starts_with("shaft");
}

std::string rotor_svg(const Model& model, const ModesResult& r, const ModeDetails& d, const Layout& l) {
  std::vector<std::size_t> pictured;
  for (std::size_t k = 0; k < r.modes.size(); ++k) {
    if (!r.modes[k].field.empty() && largest_motion(r.modes[k]) > 0) pictured.push_back(k);
  }
  const double rows = std::ceil(static_cast<double>(pictured.size()) / panel::columns), row = panel::height + panel::caption + panel::gap;
  const double width = panel::columns * (panel::width + panel::gap) + panel::gap, height = panel::head + rows * row + panel::gap;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" role=\"img\" "
      "aria-label=\"{2}\">\n",
      width, height, xml_escaped(model.title));
  out +=
      "<style>text{font-family:Helvetica,Arial,sans-serif;fill:#222}.title{font-size:18px;font-weight:bold}.caption{font-size:14px}"
      ".note{font-size:12px;fill:#666}polyline{fill:none;stroke-width:2;stroke-linejoin:round}.rest{stroke:#bbb;stroke-width:1.2}"
      ".now{stroke:#222}.quarter{stroke:#999}.disc{stroke-width:4}.orbit{stroke-width:1.1}.forward{stroke:#0072B2}"
      ".backward{stroke:#D55E00;stroke-dasharray:4 2}.flat{stroke:#CC79A7;stroke-dasharray:1 2}.bearing{stroke:#777;stroke-width:1.2}"
      ".frame{fill:#fff;stroke:#ddd}</style>\n";
  out += fmt::format("<rect width=\"{:.0f}\" height=\"{:.0f}\" fill=\"#fff\"/>\n<text x=\"{:.0f}\" y=\"28\" class=\"title\">{}</text>\n",
                     width, height, panel::gap, xml_escaped(model.title));
  out += fmt::format(
      "<text x=\"{0:.0f}\" y=\"48\" class=\"note\">black: t = 0, grey: a quarter of a period later; x upwards, y towards the viewer; "
      "motions "
      "are not to scale</text>\n<text x=\"{0:.0f}\" y=\"66\" class=\"note\">orbits: <tspan fill=\"#0072B2\">forward (drawn "
      "through)</tspan>, <tspan fill=\"#D55E00\">backward (dashed)</tspan>, planar (dotted)</text>\n",
      panel::gap);
  for (std::size_t i = 0; i < pictured.size(); ++i) {
    const double left = panel::gap + static_cast<double>(i % panel::columns) * (panel::width + panel::gap),
                 top = panel::head + std::floor(static_cast<double>(i) / panel::columns) * row;
    out += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" class=\"caption\">{}</text>\n", left, top + 18,
                       xml_escaped(words(r, d, pictured[i], l)));
    out += drawn(r, r.modes[pictured[i]], left, top + panel::caption);
  }
  return out + "</svg>\n";
}

}  // namespace gyromode::io
