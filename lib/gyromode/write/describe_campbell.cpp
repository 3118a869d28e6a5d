#include "gyromode/write/digits.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

template <class Item>
Json whirl_json(const Item& m) {
  return m.whirl ? Json(to_string(*m.whirl)) : Json(nullptr);
}

// One value of every spin, null where the branch has none.
template <class Value>
Json over_spins(const CampbellBranch& b, const Value& value) {
  Json all = Json::array();
  for (const auto& m : b.modes) all.push_back(m ? Json(value(*m)) : Json(nullptr));
  return all;
}

Json branch_coverage(const Campbell& c, const CampbellBranch& b) {
  Json all = Json::array();
  for (std::size_t s = 0; s < b.modes.size(); ++s) all.push_back(b.modes[s] ? Json(to_string(c.coverage[s].status)) : Json(nullptr));
  return all;
}

// Signed frequencies in fixed axes, the larger part first: of every spin a list, null where the branch has none.
Json fixed_axes_json(const SampledMode& m) {
  std::vector<FixedAxesPart> parts = m.fixed_axes;
  std::stable_sort(parts.begin(), parts.end(), [](const FixedAxesPart& a, const FixedAxesPart& b) { return a.share > b.share; });
  Json all = Json::array();
  for (const FixedAxesPart& p : parts) all.push_back(p.omega);
  return all;
}

// The whirl of a branch at its first and its last spin but rest.
std::string whirl_words(const Campbell& c, const CampbellBranch& b) {
  std::string first, last;
  for (std::size_t s = 0; s < b.modes.size(); ++s) {
    if (!b.modes[s] || !b.modes[s]->whirl || c.spins[s] == 0) continue;
    last = to_string(*b.modes[s]->whirl);
    if (first.empty()) first = last;
  }
  return first.empty() ? "–" : first == last ? first : first + " … " + last;
}

bool has_negative_energy(const CampbellBranch& b) {
  return std::any_of(b.modes.begin(), b.modes.end(), [](const auto& m) { return m && m->energy_sign < 0; });
}

void describe_branches(const Campbell& c, bool turning, Writer& w) {
  const auto at = [&](double spin) { return fmt::format("at {:.6g} {}", w.spin(spin), w.spin_unit()); };
  const auto words = [&](const std::optional<SampledMode>& m) {
    return m ? determined(w.frequency(m->omega), w.frequency(m->error), 8) : std::string();
  };
  const bool negative = std::any_of(c.branches.begin(), c.branches.end(), has_negative_energy);
  w.table({"",
           "",
           {{"", "branch"},
            {"", "whirl"},
            {"", w.frequency_heading() + " " + at(c.spins.front())},
            {"", at(c.spins[c.spins.size() / 2])},
            {"", at(c.spins.back())},
            {"", negative ? "energy" : ""}},
           static_cast<Index>(c.branches.size()),
           [&](Index k) {
             const CampbellBranch& b = c.branches[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{nullptr, fmt::format("{}", k + 1)}, {nullptr, whirl_words(c, b)},
                                      {nullptr, words(b.modes.front())},   {nullptr, words(b.modes[b.modes.size() / 2])},
                                      {nullptr, words(b.modes.back())},    {nullptr, has_negative_energy(b) ? "−" : "+"}};
           }});
  if (w.for_csv()) return;
  w.table({"branches",
           "",
           {{"omega"}, {"whirl"}, {"energy_sign"}, {"slope"}, {"error_bound"}, {"coverage"}, {"multiplicity"}, {"fixed_axes"}},
           static_cast<Index>(c.branches.size()),
           [&](Index k) {
             const CampbellBranch& b = c.branches[static_cast<std::size_t>(k)];
             Index multiplicity = 1;
             for (const auto& m : b.modes) multiplicity = std::max(multiplicity, m ? m->multiplicity : 1);
             return std::vector<Cell>{{over_spins(b, [](const SampledMode& m) { return m.omega; })},
                                      {over_spins(b, whirl_json<SampledMode>)},
                                      {over_spins(b, [](const SampledMode& m) { return m.energy_sign; })},
                                      {over_spins(b, [](const SampledMode& m) { return m.slope ? Json(*m.slope) : Json(nullptr); })},
                                      {over_spins(b, [](const SampledMode& m) { return m.error; })},
                                      {branch_coverage(c, b)},
                                      {multiplicity},
                                      {turning ? over_spins(b, fixed_axes_json) : no_value}};
           }});
}

void describe_encounters(const Campbell& c, Writer& w) {
  if (c.encounters.empty()) {
    w.say("encounters", c.interrupted ? "" : "none: the branches do not meet");
  }
  const bool flutter = std::any_of(c.encounters.begin(), c.encounters.end(), [](const Encounter& e) { return e.flutter.has_value(); });
  w.table({"events",
           "",
           {{"kind", "encounter"},
            {"spin", w.spin_heading()},
            {"omega", w.frequency_heading()},
            {"branches", "branches"},
            {"gap", w.frequency_heading("gap")},
            {"gap_error"},
            {"flutter", flutter ? fmt::format("off the axis [{}]", w.spin_unit()) : ""}},
           static_cast<Index>(c.encounters.size()),
           [&](Index k) {
             const Encounter& e = c.encounters[static_cast<std::size_t>(k)];
             const bool gap = e.kind == EncounterKind::veering || e.kind == EncounterKind::ambiguous;
             return std::vector<Cell>{{to_string(e.kind)},
                                      {e.spin, fmt::format("{:.8g}", w.spin(e.spin))},
                                      {e.omega, fmt::format("{:.8g}", w.frequency(e.omega))},
                                      {Json{e.branches[0], e.branches[1]}, fmt::format("{}, {}", e.branches[0] + 1, e.branches[1] + 1)},
                                      {e.gap, gap ? fmt::format("{:.3g}", w.frequency(e.gap)) : ""},
                                      {e.error},
                                      {e.flutter ? Json{(*e.flutter)[0], (*e.flutter)[1]} : no_value,
                                       e.flutter ? fmt::format("{:.7g} … {:.7g}", w.spin((*e.flutter)[0]), w.spin((*e.flutter)[1])) : ""}};
           }});
}

// All orders in one list.
std::vector<Intersection> intersections_of(const Campbell& c) {
  std::vector<Intersection> all;
  for (const Intersections& line : c.excitation) all.insert(all.end(), line.all.begin(), line.all.end());
  return all;
}

void describe_excitation(const Campbell& c, Writer& w) {
  const std::vector<Intersection> all = intersections_of(c);
  w.table({"excitation",
           "",
           {{"order", "excitation"},
            {"spin", w.spin_heading()},
            {"omega", w.frequency_heading()},
            {"branch", "branch"},
            {"whirl", "whirl"},
            {"error_bound"}},
           static_cast<Index>(all.size()),
           [&](Index k) {
             const Intersection& x = all[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{x.order, fmt::format("{:g} ×", x.order)},
                                      {x.spin, determined(w.spin(x.spin), w.spin(x.error), 8)},
                                      {x.omega, determined(w.frequency(x.omega), w.frequency(x.order * x.error), 8)},
                                      {x.branch, fmt::format("{}", x.branch + 1)},
                                      {whirl_json(x), x.whirl ? std::string(to_string(*x.whirl)) : "–"},
                                      {x.error}};
           }});
  Json counted = Json::array();
  for (const Intersections& line : c.excitation) counted.push_back({{"order", line.order}, {"status", to_string(line.coverage.status)}});
  w.fact("excitation_coverage", counted);
}

// A line a branch and spin.
void describe_csv(const Campbell& c, bool turning, Writer& w) {
  std::vector<std::pair<std::size_t, std::size_t>> all;  // spin and branch
  for (std::size_t s = 0; s < c.spins.size(); ++s) {
    for (std::size_t b = 0; b < c.branches.size(); ++b) {
      if (c.branches[b].modes[s]) all.emplace_back(s, b);
    }
  }
  w.table({"",
           "",
           {{w.spin_key("spin")},
            {"branch"},
            {w.frequency_key("omega")},
            {"frequency_hz"},
            {"whirl"},
            {"energy_sign"},
            {w.frequency_key("error_bound")},
            {"coverage"},
            {turning ? w.frequency_key("fixed_axes") : ""},
            {turning ? w.frequency_key("fixed_axes_2") : ""}},
           static_cast<Index>(all.size()),
           [all, &c, &w](Index k) {
             const auto& [s, b] = all[static_cast<std::size_t>(k)];
             const SampledMode& m = *c.branches[b].modes[s];
             const Json fixed = fixed_axes_json(m);
             const auto part = [&](std::size_t i) { return i < fixed.size() ? Json(w.frequency(fixed[i].get<double>())) : Json(nullptr); };
             return std::vector<Cell>{{w.spin(c.spins[s])},
                                      {b + 1},
                                      {w.frequency(m.omega)},
                                      {hertz(m.omega)},
                                      {whirl_json(m)},
                                      {m.energy_sign},
                                      {w.frequency(m.error)},
                                      {Json(to_string(c.coverage[s].status))},
                                      {part(0)},
                                      {part(1)}};
           },
           true});
}

}  // namespace

void describe(const Model& model, const Campbell& c, Writer& w) {
  if (w.for_csv()) {
    describe_csv(c, model.frame == gyromode::Frame::turning, w);
    return;
  }
  const auto complete =
      std::count_if(c.coverage.begin(), c.coverage.end(), [](const Coverage& x) { return x.status == CoverageStatus::complete; });
  const auto unstable = std::count(c.stability.begin(), c.stability.end(), Stability::unstable);
  w.fact("spins", c.spins, "spins",
         fmt::format("{:.6g} … {:.6g} {}, {}{}", w.spin(c.spins.front()), w.spin(c.spins.back()), w.spin_unit(), c.spins.size(),
                     model.frame == gyromode::Frame::turning ? "; frequencies in the turning axes of the model" : ""));
  w.say("coverage", fmt::format("complete at {} of {} spins", complete, c.spins.size()));
  if (unstable > 0) w.say("unstable", fmt::format("at {} of {} spins", unstable, c.spins.size()));
  Json statuses = Json::array(), verdicts = Json::array();
  for (const Coverage& x : c.coverage) statuses.push_back(to_string(x.status));
  for (const Stability x : c.stability) verdicts.push_back(to_string(x));
  w.fact("coverage", statuses);
  w.fact("stability", verdicts);
  w.fact("growth_rate", c.growth_rate);
  if (c.interrupted) w.fact("interrupted", true, "interrupted", "higher spins were not looked at");
  describe_branches(c, model.frame == gyromode::Frame::turning, w);
  describe_encounters(c, w);
  describe_excitation(c, w);
}

}  // namespace gyromode::io
