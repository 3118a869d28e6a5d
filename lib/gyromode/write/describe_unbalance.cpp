#include "gyromode/write/response_svg.h"
#include "gyromode/write/words.h"

#include "gyromode/base/rounding.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

std::string mass_words(const Unbalance& u) {
  const double degrees = u.phase * 180 / std::numbers::pi;
  return fmt::format("{:g} kg m at {}{}", u.product, u.place, u.phase == 0 ? "" : fmt::format(" ({:.4g}° ahead of x)", degrees));
}

std::string note(const SynchronousPoint& p) {
  if (p.added) return "beside a critical speed";
  if (!p.participation) return "";
  switch (p.driven) {
    case Driven::yes: return fmt::format("critical speed, participation {:.2g}", *p.participation);
    case Driven::undecided:
      return fmt::format("limit at a critical speed: whether it is driven cannot be told, participation {:.1g}", *p.participation);
    default: return "limit at a critical speed that is not driven";
  }
}

void describe_critical_speeds(const UnbalanceReport& r, Writer& w) {
  w.table({"critical_speeds",
           "",
           {{w.spin_key("omega"), "critical " + w.spin_heading(), "{:.10g}"},
            {"error_bound"},
            {"driven", "driven"},
            {"participation", "participation", "{:.3g}"},
            {"resolution"}},
           static_cast<Index>(r.response.critical.size()),
           [&](Index k) {
             const DrivenMode& m = r.response.critical[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{w.spin(m.omega)}, {m.error}, {to_string(m.driven)}, {m.participation}, {m.resolution}};
           }});
}

// People see the longer half axes of the places that move most; programs all coordinates, and the orbits.
void describe_points(const UnbalanceReport& r, Writer& w) {
  constexpr std::size_t most_columns = 6;
  const std::vector<std::size_t> shown = highest(peaks_of(r), most_columns);
  Table t{"points", "", {{w.spin_key("speed"), w.spin_heading(), "{:.10g}"}}, static_cast<Index>(r.response.points.size()), {}, true};
  if (w.for_json()) {
    t.columns.insert(t.columns.end(), {{"resonance"}, {"added"}, {"driven"}, {"participation"}, {"re"}, {"im"}, {"major"}, {"minor"}});
  } else if (w.for_csv()) {
    t.columns.insert(t.columns.end(), {{"resonance"}, {"added"}});
    for (const std::string& label : r.labels) t.columns.insert(t.columns.end(), {{label + " amplitude"}, {label + " phase"}});
    for (const OrbitCoordinates& p : r.places) t.columns.insert(t.columns.end(), {{p.name + " major"}, {p.name + " minor"}});
    t.columns.insert(t.columns.end(), {{"driven"}, {"participation"}});
  } else {
    for (const std::size_t k : shown) t.columns.push_back({"", r.places[k].name + " [m]", "{:.6g}"});
    t.columns.push_back({"", "note"});
  }
  t.row = [&, shown, json = w.for_json(), csv = w.for_csv()](Index row) {
    const SynchronousPoint& p = r.response.points[static_cast<std::size_t>(row)];
    const Cell driven{p.participation && !p.added ? Json(to_string(p.driven)) : no_value},
        participation{p.participation ? Json(*p.participation) : no_value};
    const auto orbit = [&](std::size_t k) { return p.resonance() ? Orbit{infinity, std::nan(""), 0} : r.orbit(p, k); };
    std::vector<Cell> cells{{w.spin(p.speed)}};
    if (json) {
      Json re, im, major = Json::array(), minor = Json::array();
      if (!p.resonance()) {
        const Vector real = p.q.real(), imaginary = p.q.imag();
        re = std::vector<double>(real.begin(), real.end());
        im = std::vector<double>(imaginary.begin(), imaginary.end());
        for (std::size_t k = 0; k < r.places.size(); ++k) {
          major.push_back(orbit(k).major);
          minor.push_back(orbit(k).minor);
        }
      }
      cells.insert(cells.end(), {{p.resonance()}, {p.added}, driven, participation, {re}, {im}, {major}, {minor}});
    } else if (csv) {
      cells.insert(cells.end(), {{p.resonance() ? 1 : 0}, {p.added ? 1 : 0}});
      for (Index i = 0; i < static_cast<Index>(r.labels.size()); ++i)
        cells.insert(cells.end(),
                     {{p.resonance() ? Json(infinity) : Json(std::abs(p.q(i)))}, {p.resonance() ? Json(nullptr) : Json(std::arg(p.q(i)))}});
      for (std::size_t k = 0; k < r.places.size(); ++k)
        cells.insert(cells.end(), {{orbit(k).major}, {p.resonance() ? Json(nullptr) : Json(orbit(k).minor)}});
      cells.insert(cells.end(), {driven, participation});
    } else {
      for (const std::size_t k : shown) cells.push_back(p.resonance() ? Cell{nullptr, "∞"} : Cell{orbit(k).major});
      cells.push_back({nullptr, note(p)});
    }
    return cells;
  };
  w.table(t);
}

}  // namespace

void describe(const Model& model, const UnbalanceReport& r, Writer& w) {
  Json masses = Json::array(), places = Json::array();
  std::string words;
  for (const Unbalance& u : r.masses) {
    masses.push_back({{"place", u.place}, {"unbalance", u.product}, {"phase", u.phase}});
    words += (words.empty() ? "" : ", ") + mass_words(u);
  }
  for (const OrbitCoordinates& p : r.places) {
    places.push_back({{"name", p.name},
                      {"position", p.along},
                      {"x", r.labels[static_cast<std::size_t>(p.x)]},
                      {"y", r.labels[static_cast<std::size_t>(p.y)]}});
  }
  w.fact("unbalance", masses, "unbalance", words);
  w.fact("order", r.response.order, "", "");
  w.say("frequency", model.frame == gyromode::Frame::turning
                         ? fmt::format("{:g} × speed in the turning axes of the model", r.response.order)
                         : fmt::format("{:g} × speed", r.response.order));
  w.fact("labels", r.labels);
  w.fact("places", places);
  w.fact("critical_coverage", to_string(r.response.coverage.status));
  w.fact("resonances", r.response.resonances());
  if (r.response.interrupted) w.fact("interrupted", true, "interrupted", "higher speeds were not computed");
  describe_critical_speeds(r, w);
  w.say("orbits",
        r.response.order > 0 ? "longer half axes, of the places that move most" : "radii in fixed axes, of the places that move most");
  describe_points(r, w);
}

}  // namespace gyromode::io
