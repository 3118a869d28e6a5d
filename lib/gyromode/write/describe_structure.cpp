#include "gyromode/structure/symmetry_words.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace gyromode::io {

namespace {

std::string witness_words(const Labels& labels, const OddCycle& w) {
  std::string out = "a closed walk with an odd number of G couplings: " + labels[static_cast<std::size_t>(w.coordinates.front())];
  for (std::size_t k = 0; k < w.kinds.size(); ++k) {
    const Index next = w.coordinates[(k + 1) % w.coordinates.size()];
    out += fmt::format(" —{}— {}", w.kinds[k] == CouplingKind::cross ? "G" : "M,K", labels[static_cast<std::size_t>(next)]);
  }
  return out;
}

void describe_witness(const Model& model, const Structure& s, Writer& w) {
  const auto witness = s.witness();
  if (!witness) return;
  Json kinds = Json::array();
  for (const CouplingKind k : witness->kinds) kinds.push_back(k == CouplingKind::cross ? "G" : "M or K");
  w.fact("witness", labels_of(model.labels(), witness->coordinates),
         s.system_class() == SystemClass::hidden_quadrature ? "not visible" : "why not",
         witness->kinds.empty() || s.system_class() == SystemClass::quadrature ? "" : witness_words(model.labels(), *witness));
  w.fact("witness_couplings", std::move(kinds));
}

void describe_symmetries(const Model& model, const std::vector<SymmetryFinding>& findings, Writer& w) {
  Json all = Json::array();
  for (const SymmetryFinding& f : findings) {
    Json one{{"labels", labels_of(model.labels(), f.coordinates)},
             {"found", f.reflection.has_value()},
             {"breach", f.departure},
             {"threshold", f.threshold},
             {"amplification", f.amplification}};
    if (f.reflection) {
      const std::string words = in_words(*f.reflection, chosen(model.labels(), f.coordinates));
      one["in_words"] = words;
      one["reflection"] = rows_of(*f.reflection);
      w.say("symmetry", words);
      w.say("", fmt::format("commutes with K, anticommutes with G to {:.1e}, where rounding explains {:.1e}", f.departure, f.threshold));
    } else {
      w.say("symmetry", fmt::format("none reverses the spin: the nearest reflection misses by {:.2g}, where rounding explains {:.1e}",
                                    f.departure, f.threshold));
    }
    all.push_back(std::move(one));
  }
  if (!findings.empty()) w.fact("reversing_symmetry", std::move(all));
}

void describe_components(const Model& model, const Structure& s, Writer& w) {
  Json all = Json::array();
  for (const Component& c : s.components) all.push_back(labels_of(model.labels(), c.coordinates));
  w.fact("components", std::move(all), "components", fmt::format("{}", s.components.size()));
}

void tabulate_components(const Model& model, const Structure& s, Writer& w) {
  if (s.components.size() < 2) return;
  w.table({"", "", {{"", "component"}, {"", "coordinates"}, {"", "class"}}, static_cast<Index>(s.components.size()), [&](Index k) {
             const Component& c = s.components[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{k + 1},
                                      {joined(model.labels(), c.coordinates)},
                                      {c.quadrature()          ? "quadrature"
                                       : c.hidden_quadrature() ? "hidden quadrature"
                                                               : "general"}};
           }});
}

Json json_of(double x) { return x; }
Json json_of(const std::string& x) { return x; }
Json json_of(const Matrix& a) { return rows_of(a); }
Json json_of(const std::vector<std::pair<std::string, double>>& numbers) {
  Json j;
  for (const auto& [name, x] : numbers) j[name] = x;
  return j;
}

void describe_booms(const StructureReport& r, Writer& w) {
  if (!r.clamped_booms.empty()) {
    w.table({"held_booms",
             "",
             {{"name", "boom on a body held"}, {w.frequency_key("omega"), w.frequency_heading()}},
             static_cast<Index>(r.clamped_booms.size()),
             [&](Index k) {
               const ClampedBoom& b = r.clamped_booms[static_cast<std::size_t>(k)];
               std::vector<double> shown;
               for (const double omega : b.frequencies) shown.push_back(w.frequency(omega));
               return std::vector<Cell>{{b.name}, {shown, fmt::format("{:.6g}", fmt::join(shown, "  "))}};
             }});
  }
  if (r.effective_axes.empty()) return;
  w.table({"effective_axes",
           "ψ: from axis 1 to the principal axis of the effective inertia of hub and booms at the frequency of each mode; about it "
           "rotations are in phase, across it in quadrature",
           {{w.frequency_key("omega"), w.frequency_heading(), "{:.10g}"}, {"psi", "ψ [°]"}},
           static_cast<Index>(r.effective_axes.size()),
           [&](Index k) {
             const EffectiveAxes& e = r.effective_axes[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{w.frequency(e.omega)}, {e.angle, fmt::format("{:.8g}", e.angle * 180 / std::numbers::pi)}};
           }});
}

void tabulate(const std::string& name, const Labels& labels, const ComplexMatrix& a, Writer& w) {
  Table t{"", "", {{"", name}}, a.rows(), {}};
  for (const std::string& label : labels) t.columns.push_back({"", label});
  t.row = [&](Index i) {
    std::vector<Cell> row{{labels[static_cast<std::size_t>(i)]}};
    for (Index k = 0; k < a.cols(); ++k) row.push_back({nullptr, complex_words(a(i, k))});
    return row;
  };
  w.table(t);
}

std::string how_words(const Realified& at) {
  switch (at.how) {
    case Realification::partition: return "T = diag(1 in phase, −j in quadrature), the same at every ω";
    case Realification::angle: return fmt::format("S(ψ) with ψ = {:.8g}°, for this ω", *at.angle * 180 / std::numbers::pi);
    default: return "reflections and phases, for this ω: H* is tridiagonal";
  }
}

void describe_impedance(const Model& model, const RealifiedAt& r, Writer& w) {
  const Realified& at = r.realified;
  const int sign = at.determinant_sign();
  tabulate(fmt::format("H({:.6g} {})", in_unit(r.omega, w.layout().unit), w.frequency_unit()), model.labels(), at.impedance, w);
  tabulate("U", model.labels(), at.unitary, w);
  tabulate("H* = UᴴHU", model.labels(), at.real_symmetric.cast<Complex>(), w);
  w.fact("at", {{"omega", r.omega},
                {"H", complex_rows(at.impedance)},
                {"transformation", complex_rows(at.unitary)},
                {"H_star", rows_of(at.real_symmetric)},
                {"by", to_string(at.how)},
                {"negative", at.negative()},
                {"determinant_sign", sign}});
  if (at.angle) w.fact("at.psi", *at.angle);
  w.say("U", how_words(at));
  w.say("n₋(H)", fmt::format("{}; det H is {}", at.negative(),
                             sign > 0   ? "positive"
                             : sign < 0 ? "negative"
                                        : "zero to rounding: a resonance"));
}

// A row a coordinate: its component and its group.
void tabulate_groups(const Model& model, const Structure& s, Writer& w) {
  std::vector<std::pair<Index, std::size_t>> places;
  for (std::size_t c = 0; c < s.components.size(); ++c) {
    for (const Index i : s.components[c].coordinates) places.emplace_back(i, c);
  }
  w.table({"",
           "",
           {{"coordinate"}, {"component"}, {"group"}},
           static_cast<Index>(places.size()),
           [&](Index k) {
             const auto [i, c] = places[static_cast<std::size_t>(k)];
             const std::vector<Index>& q = s.components[c].in_quadrature;
             const bool second = std::find(q.begin(), q.end(), i) != q.end();
             return std::vector<Cell>{{model.labels()[static_cast<std::size_t>(i)]},
                                      {c + 1},
                                      {!s.components[c].quadrature() ? "mixed"
                                       : second                      ? "quadrature"
                                                                     : "in_phase"}};
           },
           true});
}

// What an inspection of a mesh tells, a line each: the names and numbers that people look for.
void describe_checks(const std::vector<ModelCheck>& checks, Writer& w) {
  using Numbers = std::vector<std::pair<std::string, double>>;
  constexpr std::pair<std::string_view, std::string_view> headings[] = {
      {"nodes", "nodes"},       {"mass_per_direction", "mass"}, {"centre", "centre"},  {"inertia", "inertia"},
      {"symmetry", "symmetry"}, {"scales", "scales"},           {"entries", "entries"}};
  for (const ModelCheck& c : checks) {
    w.fact("checks." + c.name, std::visit([](const auto& x) { return json_of(x); }, c.value));
    const auto heading = std::find_if(std::begin(headings), std::end(headings), [&](const auto& h) { return h.first == c.name; });
    if (heading == std::end(headings)) continue;
    std::string words;
    if (const auto* numbers = std::get_if<Numbers>(&c.value)) {
      for (const auto& [name, value] : *numbers) words += fmt::format("{}{} {:.8g}", words.empty() ? "" : ", ", name, value);
    } else if (const auto* text = std::get_if<std::string>(&c.value)) {
      words = *text;
    } else if (const auto* number = std::get_if<double>(&c.value)) {
      words = fmt::format("{:.8g}", *number);
    }
    if (!words.empty()) w.say(heading->second, words);
  }
}

}  // namespace

void describe(const Model& model, const StructureReport& r, Writer& w) {
  const Structure& s = r.structure;
  describe_class(model, s, r.stiffness, r.stiffness_applies, w);
  describe_repairs(r.repairs, w);
  w.say("class", class_words(model, s));
  if (s.system_class() == SystemClass::quadrature) {
    w.say("in phase", joined(model.labels(), s.in_phase()));
    w.say("quadrature", joined(model.labels(), s.in_quadrature()));
    w.say("H*", "T = diag(1 in phase, −j in quadrature) makes H(ω) real symmetric at every ω");
  }
  describe_witness(model, s, w);
  describe_symmetries(model, r.symmetries, w);
  if (r.stiffness_applies) w.say("stiffness", stiffness_words(r.stiffness));
  describe_components(model, s, w);
  if (model.ignored) w.say("left out", in_words(*model.ignored));
  describe_checks(r.checks, w);
  w.fact("checks.coupling_tolerance", model.ignored ? model.ignored->tolerance : 0);
  tabulate_components(model, s, w);
  describe_booms(r, w);
  if (r.at) describe_impedance(model, *r.at, w);
  tabulate_groups(model, s, w);
}

}  // namespace gyromode::io
