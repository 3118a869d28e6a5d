#include "gyromode/write/digits.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode::io {

namespace {

// What damping D > 0 at rest in the axes of the model makes of it: as many growing roots as K has negative eigenvalues,
// K singular or not (Kelvin, Tait, Chetaev; Zajac 1964; theory §5).
std::string damping_words(const ModesResult& r) {
  const Index growing = r.index_balance.negative;
  if (growing == 0) return "that is at rest in these axes makes every vibration decay";
  return fmt::format("that is at rest in these axes leaves {} growing, as K has {} negative{}",
                     growing == 1 ? "1 root" : fmt::format("{} roots", growing), growing,
                     r.negative_modes.empty() ? "" : fmt::format(": each mode of negative energy grows ({})", r.negative_modes.size()));
}

void describe_damping(const ModesResult& r, Writer& w) {
  if (r.first_order) return;
  Json destabilised = Json::array();
  for (const Mode& m : r.negative_modes) destabilised.push_back(m.omega);
  w.fact("damping", {{"growing_roots", r.index_balance.negative}, {"destabilised", std::move(destabilised)}}, "damping", damping_words(r));
}

void describe_margin(const StabilityReport& report, Writer& w) {
  const double gap = report.result.opposite_gap;
  std::string words;
  if (report.opposite) {
    const auto [a, b] = *report.opposite;
    words = fmt::format("roots of opposite energy sign come nearest at {:.10g} and {:.10g} rad/s, {:.3g} apart", a, b, b - a);
  } else if (std::isfinite(gap)) {
    words = fmt::format("nearest roots of opposite energy sign are {:.3g} apart, relative", gap);
  }
  w.fact("margin",
         {{"opposite_sign_gap", gap},
          {"opposite_pair", report.opposite ? Json(*report.opposite) : Json(nullptr)},
          {"stiffness", report.stiffness ? Json(*report.stiffness) : Json(nullptr)}},
         "margin", words);
  if (report.stiffness) w.say("", fmt::format("the eigenvalue of (K, M) nearest to zero is {:.6g} rad²/s²", *report.stiffness));
}

void describe_negative_modes(const Model& model, const std::vector<Mode>& modes, Writer& w) {
  w.table(modes_table(model, "negative_modes", modes, w));
  w.table({"",
           "modes of negative energy",
           {{"", "ω [rad/s]"}, {"", "energy"}, {"", "error bound", "{:.1e}"}, {"", "largest in"}},
           static_cast<Index>(modes.size()),
           [&](Index k) {
             const Mode& m = modes[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{nullptr, determined(m.omega, m.error_bound)},
                                      {m.energy_sign < 0 ? "−" : "0: a pair of both signs"},
                                      {m.error_bound},
                                      {nullptr, largest_in(model.labels(), m.shape)}};
           }});
}

std::string verdict_word(const StabilityPoint& p) { return p.law_kept ? std::string(to_string(p.stability)) : "no model"; }

// Beside one with the same verdict the numbers that tell them apart.
std::string verdict_beside(const StabilityPoint& p, const StabilityPoint& other) {
  if (p.stability != other.stability) return verdict_word(p);
  return fmt::format("{}: {} divergent, {} flutter, {} of negative energy", verdict_word(p), p.balance.real_pairs, p.balance.quadruples,
                     p.balance.negative_energy);
}

Json verdict(const StabilityPoint& p) { return p.law_kept ? Json(to_string(p.stability)) : Json(nullptr); }
Json motions(const StabilityPoint& p) {
  return {{"real_pairs", p.balance.real_pairs}, {"quadruples", p.balance.quadruples}, {"negative_energy", p.balance.negative_energy}};
}

char letter(const StabilityPoint& p) {
  if (!p.law_kept) return ' ';
  switch (p.stability) {
    case Stability::stable: return 's';
    case Stability::gyroscopically_stabilised: return 'g';
    case Stability::marginal: return 'm';
    case Stability::unstable: return p.balance.quadruples > 0 ? 'F' : 'D';
    default: return '?';
  }
}

// The second parameter upwards, the first to the right.
std::string chart(const StabilityReport& r) {
  const auto& along = r.map->axes[0];
  const auto& across = r.map->axes[1];
  std::string out = fmt::format("{} upwards, {} to the right\n", r.varied[1], r.varied[0]);
  for (std::size_t j = across.size(); j-- > 0;) {
    out += fmt::format("{:>12.6g} ", across[j]);
    for (std::size_t i = 0; i < along.size(); ++i) out += letter(r.map->cells[j * along.size() + i].point);
    out += "\n";
  }
  const std::string last = fmt::format("{:.6g}", along.back()), first = fmt::format("{:.6g}", along.front());
  out += fmt::format("{:>13}{}{}{}\n", "", first,
                     std::string(along.size() > first.size() + last.size() ? along.size() - first.size() - last.size() : 1, ' '), last);
  return out + "s stable, g gyroscopically stabilised, D divergence, F flutter, m marginal, ? unknown, blank: no such model\n";
}

// People see a line of cells, or the chart; programs all cells.
void describe_cells(const StabilityReport& r, Writer& w) {
  const bool line = r.varied.size() == 1;
  Table t{"map", "", {{"values", "", "", Column::In::json}}, static_cast<Index>(r.map->cells.size()), {}, true};
  for (const std::string& key : r.varied) t.columns.push_back({key, line ? key : "", "{:.10g}", Column::In::csv});
  for (const auto& [key, heading] : {std::pair("stability", "verdict"),
                                     {"growth_rate", "growth rate [1/s]"},
                                     {"real_pairs", "divergent"},
                                     {"quadruples", "flutter"},
                                     {"negative_energy", "negative energy"}}) {
    t.columns.push_back({key, line ? heading : "", "{:.6g}"});
  }
  t.columns.push_back({"reason", "", "", Column::In::json});
  t.row = [&, csv = w.for_csv()](Index k) {
    const StabilityMap::Cell& cell = r.map->cells[static_cast<std::size_t>(k)];
    const StabilityPoint& p = cell.point;
    const auto unless_unlawful = [&](auto x) { return csv && !p.law_kept ? Json(nullptr) : Json(x); };
    std::vector<Cell> row{{cell.values}};
    for (const double v : cell.values) row.push_back({v});
    row.insert(row.end(), {{csv && !p.law_kept ? Json("no_model") : verdict(p), verdict_word(p)},
                           {unless_unlawful(p.growth_rate), p.law_kept ? "" : " "},
                           {unless_unlawful(p.balance.real_pairs)},
                           {unless_unlawful(p.balance.quadruples)},
                           {unless_unlawful(p.balance.negative_energy)},
                           {p.reason.empty() ? no_value : Json(p.reason)}});
    return row;
  };
  w.table(t);
  if (!line) w.drawing(chart(r));
}

void describe_critical(const StabilityReport& r, Writer& w) {
  Table t{"critical",
          fmt::format("critical values, from {} verdicts between those of the grid", r.map->evaluations),
          {{"key"},
           {"value", r.varied[0], "{:.15g}"},
           {"", r.varied.size() > 1 ? "at " + r.varied[1] : ""},
           {"bracket", "bracket"},
           {"from", "from"},
           {"to", "to"},
           {"motions"},
           {"at"}},
          static_cast<Index>(r.map->critical.size()),
          {}};
  t.row = [&](Index k) {
    const CriticalValue& c = r.map->critical[static_cast<std::size_t>(k)];
    Json at = no_value;
    if (!c.others.empty()) at = {{r.varied[1], c.others[0]}};
    return std::vector<Cell>{{r.varied[c.axis]},
                             {c.value},
                             {nullptr, c.others.empty() ? "" : fmt::format("{:.10g}", c.others[0])},
                             {{c.lo, c.hi}, fmt::format("{:.1e} wide", c.hi - c.lo)},
                             {verdict(c.from), verdict_beside(c.from, c.to)},
                             {verdict(c.to), verdict_beside(c.to, c.from)},
                             {{{"from", motions(c.from)}, {"to", motions(c.to)}}},
                             {at}};
  };
  w.table(t);
  if (r.map->critical.empty() && !r.map->interrupted) w.paragraph("no critical value between the points of the grid");
}

void describe_map(const StabilityReport& r, Writer& w) {
  w.fact("varied", r.varied);
  describe_cells(r, w);
  describe_critical(r, w);
  if (r.map->interrupted) w.fact("interrupted", true, "interrupted", "cells without a verdict were not looked at");
  w.fact("evaluations", {{"cells", r.map->cells.size()}, {"between", r.map->evaluations}});
}

}  // namespace

void describe(const Model& model, const StabilityReport& report, Writer& w) {
  const ModesResult& r = report.result;
  const IndexBalance& b = r.index_balance;
  w.fact("stability", to_string(r.stability), "stability", stability_words(r.stability) + repaired_words(r.repairs));
  describe_balance(b, w);
  describe_repairs(r.repairs, w);
  if (!r.first_order) {
    w.say("stiffness", stiffness_words(r.stiffness));
    w.say("balance", balance_words(b));
  }
  describe_damping(r, w);
  describe_margin(report, w);
  describe_negative_modes(model, r.negative_modes, w);
  w.table(unstable_table(model, r.unstable, w, false));
  if (report.map) return describe_map(report, w);
  w.table({"",
           "",
           {{"stability"}, {"negative"}, {"real_pairs"}, {"quadruples"}, {"negative_energy"}, {"zero"}, {"zero_negative"}, {"closed"}},
           1,
           [&](Index) {
             return std::vector<Cell>{{to_string(r.stability)}, {b.negative}, {b.real_pairs},    {b.quadruples},
                                      {b.negative_energy},      {b.zero},     {b.zero_negative}, {b.closed}};
           },
           true});
}

}  // namespace gyromode::io
