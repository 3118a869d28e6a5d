#include "gyromode/write/words.h"
#include "gyromode/base/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <complex>

namespace gyromode::io {

namespace {

void describe_shares(const ResponseReport& r, Writer& w) {
  Table t{"modal",
          "",
          {{w.frequency_key("omega"), w.frequency_heading(), "{:.15g}"},
           {"amplitude", "amplitude", "{:.6g}"},
           {"phase", "phase [rad]", "{:.6g}"},
           {"energy", "energy", "{:.6g}"},
           {"energy_sign"},
           {"", "largest in"},
           {"shape"}},
          static_cast<Index>(r.modal.size()),
          {}};
  t.row = [&](Index k) {
    const ModalShare& m = r.modal[static_cast<std::size_t>(k)];
    return std::vector<Cell>{{w.frequency(m.omega)},
                             {m.amplitude},
                             {m.phase},
                             {m.energy},
                             {m.energy_sign},
                             {nullptr, largest_in(r.labels, m.shape)},
                             {w.for_json() ? shape_json(r.labels, m.shape) : no_value}};
  };
  w.table(t);
}

// A row a time; people see the first coordinates.
void describe_history(const ResponseReport& r, Writer& w) {
  constexpr std::size_t most_columns = 8;
  const std::size_t n = r.labels.size(), shown = w.for_csv() ? n : std::min(n, most_columns);
  Table t{"", "", {{"t", "t [s]", "{:g}"}}, r.history.t.size(), {}, true};
  for (std::size_t i = 0; i < shown; ++i) t.columns.push_back({r.labels[i], r.labels[i], "{:.8g}"});
  if (r.rates && w.for_csv()) {
    for (const std::string& label : r.labels) t.columns.push_back({label + " rate", ""});
  }
  t.row = [&, shown, rates = r.rates && w.for_csv()](Index k) {
    std::vector<Cell> row{{r.history.t(k)}};
    for (std::size_t i = 0; i < shown; ++i) row.push_back({r.history.q(static_cast<Index>(i), k)});
    if (rates) {
      for (const double v : r.history.qdot.col(k)) row.push_back({v});
    }
    return row;
  };
  w.table(t);
  w.fact("t", std::vector<double>(r.history.t.begin(), r.history.t.end()));
  if (!w.for_json()) return;
  w.fact("q", rows_of(r.history.q.transpose()));
  if (r.rates) w.fact("qdot", rows_of(r.history.qdot.transpose()));
}

std::string note(const FrequencyPoint& p) {
  if (p.added) return "beside a resonance";
  if (!p.participation) return "";
  switch (p.driven) {
    case Driven::yes: return fmt::format("resonance, participation {:.2g}", *p.participation);
    case Driven::undecided:
      return fmt::format("limit at a mode: whether it is driven cannot be told, participation {:.1g}", *p.participation);
    default: return "limit at a mode that is not driven";
  }
}

void describe_points(const FrequencyReport& r, Writer& w) {
  constexpr std::size_t most_columns = 6;
  const std::size_t n = r.labels.size(), shown = std::min(n, most_columns);
  Table t{"points", "",  {{w.frequency_key("omega"), w.frequency_heading(), "{:.10g}"}}, static_cast<Index>(r.response.points.size()),
          {},       true};
  if (w.for_json())
    t.columns.insert(t.columns.end(), {{"resonance"}, {"added"}, {"driven"}, {"participation"}, {"re"}, {"im"}});
  else if (w.for_csv()) {
    t.columns.insert(t.columns.end(), {{"resonance"}, {"added"}});
    for (const std::string& label : r.labels) t.columns.insert(t.columns.end(), {{label + " re"}, {label + " im"}});
    t.columns.insert(t.columns.end(), {{"driven"}, {"participation"}});
  } else {
    for (std::size_t i = 0; i < shown; ++i) t.columns.push_back({"", "|" + r.labels[i] + "|", "{:.6g}"});
    t.columns.push_back({"", "note"});
  }
  t.row = [&, shown, json = w.for_json(), csv = w.for_csv()](Index k) {
    const FrequencyPoint& p = r.response.points[static_cast<std::size_t>(k)];
    const Cell driven{p.participation && !p.added ? Json(to_string(p.driven)) : no_value},
        participation{p.participation ? Json(*p.participation) : no_value};
    std::vector<Cell> row{{w.frequency(p.omega)}};
    if (json) {
      const Vector re = p.q.real(), im = p.q.imag();
      const auto list = [&](const Vector& v) { return p.resonance() ? Json(nullptr) : Json(std::vector<double>(v.begin(), v.end())); };
      row.insert(row.end(), {{p.resonance()}, {p.added}, driven, participation, {list(re)}, {list(im)}});
    } else if (csv) {
      row.insert(row.end(), {{p.resonance() ? 1 : 0}, {p.added ? 1 : 0}});
      for (Index i = 0; i < static_cast<Index>(r.labels.size()); ++i)
        row.insert(row.end(), {{p.resonance() ? infinity : p.q(i).real()}, {p.resonance() ? Json(nullptr) : Json(p.q(i).imag())}});
      row.insert(row.end(), {driven, participation});
    } else {
      for (std::size_t i = 0; i < shown; ++i)
        row.push_back(p.resonance() ? Cell{nullptr, "∞"} : Cell{std::abs(p.q(static_cast<Index>(i)))});
      row.push_back({nullptr, note(p)});
    }
    return row;
  };
  w.table(t);
}

}  // namespace

void describe(const Model&, const ResponseReport& r, Writer& w) {
  w.fact("stability", to_string(r.stability), "stability", stability_words(r.stability));
  w.fact("labels", r.labels);
  w.fact("energy", {{"initial", r.initial_energy}, {"zero_roots", r.zero_energy}, {"growing_or_double_roots", r.remainder_energy}},
         "energy",
         fmt::format("{:.10g} at first; {:.6g} in zero roots, {:.6g} in growing motion and double roots, the rest in modes",
                     r.initial_energy, r.zero_energy, r.remainder_energy));
  if (r.coverage) describe_coverage(*r.coverage, w.layout().unit, w);
  if (r.energy_left_out) w.fact("energy_left_out", *r.energy_left_out);
  w.say("accuracy", fmt::format("{:.1e} of the motion at first; phases at the last time to {:.1e} rad", r.departure, r.phase_error));
  w.fact("departure", r.departure);
  w.fact("phase_error", r.phase_error);
  w.fact("balance_closed", r.balance_closed);
  if (!r.remark.empty()) w.fact("remark", r.remark, "remark", r.remark);
  if (r.history.interrupted) w.fact("interrupted", true, "interrupted", "later times were not computed");
  describe_shares(r, w);
  describe_history(r, w);
}

void describe(const Model&, const FrequencyReport& r, Writer& w) {
  w.fact("labels", r.labels);
  w.fact("resonances", r.response.resonances());
  if (r.response.coverage) describe_coverage(*r.response.coverage, w.layout().unit, w);
  if (r.response.interrupted) w.fact("interrupted", true, "interrupted", "higher frequencies were not computed");
  w.table({"modes",
           "",
           {{"omega"}, {"error_bound"}, {"driven"}, {"participation"}, {"resolution"}},
           static_cast<Index>(r.response.modes.size()),
           [&](Index k) {
             const DrivenMode& m = r.response.modes[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{m.omega}, {m.error}, {to_string(m.driven)}, {m.participation}, {m.resolution}};
           }});
  describe_points(r, w);
}

}  // namespace gyromode::io
