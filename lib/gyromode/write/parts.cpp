// What several documents have in common.
#include "gyromode/write/digits.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <cmath>
#include <numeric>

namespace gyromode::io {

namespace {

std::string sign_words(int sign) { return sign > 0 ? "+" : sign < 0 ? "−" : "0"; }
std::string measured(double x) { return std::isfinite(x) ? fmt::format("{:.1e}", x) : "–"; }

}  // namespace

Json displacements(const std::vector<ComplexMatrix>& field) {
  if (field.empty()) return no_value;
  Json re = Json::array(), im = Json::array();
  for (const ComplexMatrix& line : field) {
    for (Index k = 0; k < line.cols(); ++k) {
      re.push_back({line(0, k).real(), line(1, k).real(), line(2, k).real()});
      im.push_back({line(0, k).imag(), line(1, k).imag(), line(2, k).imag()});
    }
  }
  return {{"re", std::move(re)}, {"im", std::move(im)}};
}

namespace {

// A shape in two columns a coordinate.
void add_shape_columns(const Labels& labels, Table& t) {
  for (const std::string& label : labels) {
    for (const char* part : {" re", " im"}) t.columns.push_back({label + part, "", "{}", Column::In::csv});
  }
}

void add_shape(const Labels& labels, const ComplexVector& shape, std::vector<Cell>& row) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const bool there = shape.size() > 0;
    row.push_back({there ? Json(shape(static_cast<Index>(i)).real()) : no_value, ""});
    row.push_back({there ? Json(shape(static_cast<Index>(i)).imag()) : no_value, ""});
  }
}

}  // namespace

Json labels_of(const Labels& labels, const std::vector<Index>& coordinates) {
  Json all = Json::array();
  for (const Index i : coordinates) all.push_back(labels[static_cast<std::size_t>(i)]);
  return all;
}

Json rows_of(const Matrix& a) {
  Json rows = Json::array();
  for (Index i = 0; i < a.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < a.cols(); ++j) row.push_back(a(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json bounds(const Window& w) { return Json::array({w.a, w.b}); }
Json complex_rows(const ComplexMatrix& a) { return {{"re", rows_of(a.real())}, {"im", rows_of(a.imag())}}; }

Json shape_json(const Labels& labels, const ComplexVector& shape) {
  if (shape.size() == 0) return no_value;
  const Vector re = shape.real(), im = shape.imag();
  return {{"labels", labels}, {"re", std::vector<double>(re.begin(), re.end())}, {"im", std::vector<double>(im.begin(), im.end())}};
}

void describe_repairs(const std::vector<Repair>& repairs, Writer& w) {
  Json all = Json::array();
  for (const Repair& r : repairs) {
    Json one{{"matrix", r.matrix}, {"departure", r.departure}, {"size", r.size}, {"at", {r.row, r.column}}};
    if (r.largest_effect) {
      one["largest_effect"] = *r.largest_effect;
      one["omega"] = r.effect_at;
      one["error_bound"] = r.error_bound;
    }
    all.push_back(std::move(one));
  }
  if (!repairs.empty()) w.fact("repairs", std::move(all));
}

void describe_class(const Model& model, const Structure& s, const InertiaOfK& k, bool has_stiffness, Writer& w) {
  if (const Labels massless = model.body->massless(); !massless.empty()) {
    std::vector<Index> all(massless.size());
    std::iota(all.begin(), all.end(), Index{0});
    w.fact("structure.massless", massless, "no mass",
           joined(massless, all) + ": condensed exactly, K, its sign and the class are of the others");
  }
  const bool quadrature = s.system_class() == SystemClass::quadrature;
  w.fact("structure.class", model.body->transcendental() ? "transcendental" : to_string(s.system_class()));
  w.fact("structure.in_phase", quadrature ? labels_of(model.labels(), s.in_phase()) : Json::array());
  w.fact("structure.quadrature", quadrature ? labels_of(model.labels(), s.in_quadrature()) : Json::array());
  if (has_stiffness) {
    w.fact("structure.stiffness", to_string(k.definiteness()));
    w.fact("structure.negative", k.negative);
    w.fact("structure.zero", k.zero);
  }
  if (model.ignored && model.ignored->largest > 0) w.fact("structure.largest_ignored_coupling", model.ignored->largest);
}

void describe_coverage(const Coverage& c, FrequencyUnit unit, Writer& w) {
  w.fact("coverage",
         {{"status", to_string(c.status)},
          {"window", bounds(c.window)},
          {"requested", bounds(c.requested)},
          {"found", c.found},
          {"counted", c.counted ? Json(*c.counted) : Json(nullptr)}},
         "coverage", coverage_words(c, unit));
  if (!c.reason.empty()) w.fact("coverage.reason", c.reason);
}

void describe_balance(const IndexBalance& b, Writer& w) {
  w.fact("index_balance", {{"negative", b.negative},
                           {"real_pairs", b.real_pairs},
                           {"quadruples", b.quadruples},
                           {"negative_energy", b.negative_energy},
                           {"zero", b.zero},
                           {"zero_negative", b.zero_negative},
                           {"closed", b.closed}});
}

namespace {

// "disk 2 63 %, shaft 1 30 %": the parts with most of the kinetic energy.
std::string most_energy_in(const std::vector<EnergyShare>& shares) {
  constexpr double worth_saying = 0.1;
  constexpr std::size_t most = 2;
  std::vector<const EnergyShare*> order;
  for (const EnergyShare& s : shares) order.push_back(&s);
  std::stable_sort(order.begin(), order.end(), [](const EnergyShare* a, const EnergyShare* b) { return a->kinetic > b->kinetic; });
  std::string words;
  for (std::size_t k = 0; k < std::min(most, order.size()) && order[k]->kinetic >= worth_saying; ++k)
    words += fmt::format("{}{} {:.0f} %", k > 0 ? ", " : "", order[k]->part, 100 * order[k]->kinetic);
  return words;
}

// With its sign, + too, and a true minus.
std::string signed_number(double x) {
  const std::string size = fmt::format("{:.7g}", std::abs(x));
  return (x < 0 ? "−" : "+") + size;
}

// As a person reads a mode: with the digits that are determined; modes that read alike are one line.
struct ModeLine {
  std::string omega, hertz, kind, whirl, fixed_axes, where;
  int sign;
  Index first, last;
  double residual;

  ModeLine(const Mode& m, Index at, const ModeDetails& d, const Writer& w)
      : omega(determined(w.frequency(m.omega), w.frequency(m.error_bound))),
        hertz(determined(io::hertz(m.omega), io::hertz(m.error_bound), 10)),
        kind(m.kind == ModeKind::rigid_body ? "rigid body" : to_string(m.kind)),
        sign(m.energy_sign),
        first(at),
        last(at),
        residual(m.residual) {
    const auto k = static_cast<std::size_t>(at);
    if (k < d.whirl.size() && d.whirl[k]) whirl = to_string(*d.whirl[k]);
    if (k < d.fixed_axes.size()) {
      for (const FixedAxesPart& p : d.fixed_axes[k])
        fixed_axes += fmt::format("{}{}", fixed_axes.empty() ? "" : ", ", signed_number(w.frequency(p.omega)));
    }
    if (k < d.names.size() && !d.names[k].empty()) kind = d.names[k];
    if (k < d.energy_shares.size()) where = most_energy_in(d.energy_shares[k]);
  }
  bool reads_like(const ModeLine& other) const {
    return omega == other.omega && kind == other.kind && sign == other.sign && whirl == other.whirl && fixed_axes == other.fixed_axes &&
           where == other.where;
  }
  Index count() const { return last - first + 1; }
  std::string number() const { return count() == 1 ? fmt::format("{}", first + 1) : fmt::format("{}–{}", first + 1, last + 1); }
  std::string kind_and_count() const { return count() == 1 ? kind : fmt::format("{} ×{}", kind, count()); }
};

std::vector<ModeLine> lines_of(const std::vector<Mode>& modes, const ModeDetails& d, const Writer& w) {
  std::vector<ModeLine> lines;
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const ModeLine line(modes[k], static_cast<Index>(k), d, w);
    if (lines.empty() || !lines.back().reads_like(line)) {
      lines.push_back(line);
      continue;
    }
    lines.back().last = line.last;
    lines.back().residual = std::max(lines.back().residual, line.residual);
  }
  return lines;
}

}  // namespace

Table modes_lines(const std::vector<Mode>& modes, const ModeDetails& details, const Writer& w) {
  const std::vector<ModeLine> lines = lines_of(modes, details, w);
  const auto any = [&](std::string ModeLine::*words) {
    return std::any_of(lines.begin(), lines.end(), [&](const ModeLine& m) { return !(m.*words).empty(); });
  };
  return {"",
          "",
          {{"", "#"},
           {"", w.frequency_heading()},
           {"", w.in_radians() ? "f [Hz]" : ""},
           {"", "energy"},
           {"", "residual", "{:.1e}"},
           {"", any(&ModeLine::whirl) ? "whirl" : ""},
           {"", any(&ModeLine::fixed_axes) ? w.frequency_heading("in fixed axes, + forward") : ""},
           {"", "kind"},
           {"", any(&ModeLine::where) ? "kinetic energy in" : ""}},
          static_cast<Index>(lines.size()),
          [lines](Index k) {
            const ModeLine& m = lines[static_cast<std::size_t>(k)];
            return std::vector<Cell>{{nullptr, m.number()}, {nullptr, m.omega}, {nullptr, m.hertz},      {nullptr, sign_words(m.sign)},
                                     {m.residual},          {nullptr, m.whirl}, {nullptr, m.fixed_axes}, {nullptr, m.kind_and_count()},
                                     {nullptr, m.where}};
          }};
}

namespace {

Json whirl_of_mode(const ModeDetails& d, Index k) {
  const auto i = static_cast<std::size_t>(k);
  if (i >= d.whirl.size()) return no_value;
  return d.whirl[i] ? Json(to_string(*d.whirl[i])) : Json(nullptr);
}

Json name_of_mode(const ModeDetails& d, Index k) {
  const auto i = static_cast<std::size_t>(k);
  return i < d.names.size() && !d.names[i].empty() ? Json(d.names[i]) : no_value;
}

// [{"omega", "share"}], signed.
Json fixed_axes_of_mode(const ModeDetails& d, Index k) {
  const auto i = static_cast<std::size_t>(k);
  if (i >= d.fixed_axes.size() || d.fixed_axes[i].empty()) return no_value;
  Json all = Json::array();
  for (const FixedAxesPart& p : d.fixed_axes[i]) all.push_back({{"omega", p.omega}, {"share", p.share}});
  return all;
}

// {place: {"whirl", "major", "minor", "inclination"}}
Json orbits_of_mode(const ModeDetails& d, Index k) {
  const auto i = static_cast<std::size_t>(k);
  if (i >= d.orbits.size() || d.orbits[i].empty()) return no_value;
  Json all = Json::object();
  for (const auto& [name, o] : d.orbits[i])
    all[name] = {{"whirl", to_string(o.whirl(d.spin))}, {"major", o.major}, {"minor", o.minor}, {"inclination", o.inclination}};
  return all;
}

// {"kinetic": {part: share}, "strain": {part: share}}
Json participation(const ModeDetails& d, Index k) {
  const auto i = static_cast<std::size_t>(k);
  if (i >= d.energy_shares.size() || d.energy_shares[i].empty()) return no_value;
  Json all{{"kinetic", Json::object()}};
  for (const EnergyShare& s : d.energy_shares[i]) {
    all["kinetic"][s.part] = s.kinetic;
    if (!std::isnan(s.strain)) all["strain"][s.part] = s.strain;
  }
  return all;
}

}  // namespace

Table modes_table(const Model& model, std::string key, const std::vector<Mode>& modes, const Writer& w, bool shapes_in_csv,
                  const ModeDetails& details) {
  Table t{std::move(key),
          "",
          {{w.frequency_key("omega")},
           {"frequency_hz"},
           {"growth_rate", "", "", Column::In::csv},
           {"kind"},
           {"energy_sign"},
           {"multiplicity"},
           {"residual"},
           {w.frequency_key("error_bound")},
           {"cluster", "", "", Column::In::json},
           {"bracket", "", "", Column::In::json},
           {"whirl", "", "", details.whirl.empty() ? Column::In::json : Column::In::both},
           {"name", "", "", Column::In::json},
           {"fixed_axes", "", "", Column::In::json},
           {"orbits", "", "", Column::In::json},
           {"participation", "", "", Column::In::json},
           {"shape", "", "", Column::In::json},
           {"displacements", "", "", Column::In::json}},
          static_cast<Index>(modes.size()),
          {}};
  const bool flat = shapes_in_csv, nested = w.for_json() && w.version() == 1;
  if (flat) add_shape_columns(model.labels(), t);
  t.row = [&model, &modes, &w, &details, flat, nested](Index k) {
    const Mode& m = modes[static_cast<std::size_t>(k)];
    std::vector<Cell> row{{w.frequency(m.omega)},
                          {hertz(m.omega)},
                          {0},
                          {to_string(m.kind)},
                          {m.energy_sign},
                          {m.multiplicity},
                          {m.residual},
                          {w.frequency(m.error_bound)},
                          {m.cluster > 1 ? Json(m.cluster) : no_value},
                          {m.bracket ? Json(*m.bracket) : no_value},
                          {whirl_of_mode(details, k)},
                          {name_of_mode(details, k)},
                          {fixed_axes_of_mode(details, k)},
                          {orbits_of_mode(details, k)},
                          {participation(details, k)},
                          {nested ? shape_json(model.labels(), m.shape) : no_value},
                          {nested ? displacements(m.field) : no_value}};
    if (flat) add_shape(model.labels(), m.shape, row);
    return row;
  };
  return t;
}

Table unstable_table(const Model& model, const std::vector<UnstableMode>& modes, const Writer& w, bool shapes_in_csv) {
  Table t{"unstable",
          "",
          {{"growth_rate", "growth rate [1/s]", "{:.15g}", Column::In::json},
           {w.frequency_key("omega"), w.frequency_heading()},
           {"frequency_hz", "", "", Column::In::csv},
           {"growth_rate", "", "", Column::In::csv},
           {"kind", ""},
           {"energy_sign", "", "", Column::In::csv},
           {"multiplicity", "", "", Column::In::csv},
           {"residual", "residual"},
           {w.frequency_key("error_bound"), "error bound"},
           {"", "kind"},
           {"", !modes.empty() && modes.front().shape.size() > 0 ? "largest in" : ""},
           {"shape", "", "", Column::In::json}},
          static_cast<Index>(modes.size()),
          {}};
  const bool nested = w.for_json() && w.version() == 1;
  if (shapes_in_csv) add_shape_columns(model.labels(), t);
  t.row = [&model, &modes, &w, shapes_in_csv, nested](Index k) {
    const UnstableMode& u = modes[static_cast<std::size_t>(k)];
    const char* kind = u.flutter() ? "flutter" : "divergence";
    std::vector<Cell> row{{u.growth_rate, determined(u.growth_rate, u.error_bound)},
                          {w.frequency(u.omega), determined(w.frequency(u.omega), w.frequency(u.error_bound))},
                          {hertz(u.omega), ""},
                          {u.growth_rate, ""},
                          {kind, ""},
                          {nullptr, ""},
                          {1, ""},
                          {u.residual, measured(u.residual)},
                          {w.frequency(u.error_bound), measured(w.frequency(u.error_bound))},
                          {kind, ""},
                          {nullptr, largest_in(model.labels(), u.shape)},
                          {nested ? shape_json(model.labels(), u.shape) : no_value, ""}};
    if (shapes_in_csv) add_shape(model.labels(), u.shape, row);
    return row;
  };
  return t;
}

}  // namespace gyromode::io
