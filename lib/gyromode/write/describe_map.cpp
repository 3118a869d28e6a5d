#include "gyromode/write/describe_map.h"

#include "gyromode/write/digits.h"
#include "gyromode/write/varied_parameter.h"
#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

std::string verdict_word(const StabilityPoint& p) {
  if (!p.law_kept) return "no model";
  std::string words(to_string(p.stability));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

// "2 divergent, 1 flutter"; a stable point by its verdict, with the modes of negative energy where there are some.
std::string motions_words(const StabilityPoint& p, bool with_negative_energy) {
  std::string words;
  const auto add = [&](Index n, const char* what) {
    if (n > 0) words += fmt::format("{}{} {}", words.empty() ? "" : ", ", n, what);
  };
  add(p.balance.real_pairs, "divergent");
  add(p.balance.quadruples, "flutter");
  if (words.empty()) words = verdict_word(p);
  if (with_negative_energy && p.balance.negative_energy > 0) words += fmt::format(" ({} of negative energy)", p.balance.negative_energy);
  return words;
}

std::string change_words(const StabilityPoint& from, const StabilityPoint& to) {
  const bool same = motions_words(from, false) == motions_words(to, false);
  return motions_words(from, same) + " → " + motions_words(to, same);
}

VariedParameter varied(const Model& model, const StabilityReport& r, std::size_t which, const Writer& w) {
  return {model, r.varied[which], w.layout().unit};
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
std::string chart(const Model& model, const StabilityReport& r, const Writer& w) {
  const VariedParameter right = varied(model, r, 0, w), up = varied(model, r, 1, w);
  const auto& along = r.map->axes[0];
  const auto& across = r.map->axes[1];
  std::string out = fmt::format("{} upwards, {} to the right\n", up.title(), right.title());
  for (std::size_t j = across.size(); j-- > 0;) {
    out += fmt::format("{:>12.6g} ", up.shown(across[j]));
    for (std::size_t i = 0; i < along.size(); ++i) out += letter(r.map->cells[j * along.size() + i].point);
    out += "\n";
  }
  const std::string last = fmt::format("{:.6g}", right.shown(along.back())), first = fmt::format("{:.6g}", right.shown(along.front()));
  out += fmt::format("{:>13}{}{}{}\n", "", first,
                     std::string(along.size() > first.size() + last.size() ? along.size() - first.size() - last.size() : 1, ' '), last);
  return out + "s stable, g gyroscopically stabilised, D divergence, F flutter,\nm marginal, ? unknown, blank: no model\n";
}

// People see a line of cells, or the chart; programs all cells.
void describe_cells(const Model& model, const StabilityReport& r, Writer& w) {
  const bool line = r.varied.size() == 1;
  Table t{"map", "", {{"values", "", "", Column::In::json}}, static_cast<Index>(r.map->cells.size()), {}, true};
  std::vector<VariedParameter> parameters;
  for (std::size_t k = 0; k < r.varied.size(); ++k) {
    parameters.push_back(varied(model, r, k, w));
    const std::string& key = r.varied[k];
    t.columns.push_back(
        {parameters[k].is_frequency() ? w.frequency_key(key) : key, line ? parameters[k].title() : "", "{:.10g}", Column::In::csv});
  }
  for (const auto& [key, heading] : {std::pair("stability", "verdict"),
                                     {"growth_rate", "growth rate [1/s]"},
                                     {"real_pairs", "divergent"},
                                     {"quadruples", "flutter"},
                                     {"negative_energy", "negative energy"}}) {
    t.columns.push_back({key, line ? heading : "", "{:.6g}"});
  }
  t.columns.push_back({"reason", "", "", Column::In::json});
  t.row = [&, parameters, csv = w.for_csv()](Index k) {
    const StabilityMap::Cell& cell = r.map->cells[static_cast<std::size_t>(k)];
    const StabilityPoint& p = cell.point;
    const auto unless_unlawful = [&](auto x) { return csv && !p.law_kept ? Json(nullptr) : Json(x); };
    std::vector<Cell> row{{cell.values}};
    for (std::size_t i = 0; i < cell.values.size(); ++i) row.push_back({parameters[i].shown(cell.values[i])});
    row.insert(row.end(), {{csv && !p.law_kept ? Json("no_model") : verdict(p), verdict_word(p)},
                           {unless_unlawful(p.growth_rate), p.law_kept ? "" : " "},
                           {unless_unlawful(p.balance.real_pairs)},
                           {unless_unlawful(p.balance.quadruples)},
                           {unless_unlawful(p.balance.negative_energy)},
                           {p.reason.empty() ? no_value : Json(p.reason)}});
    return row;
  };
  w.table(t);
  if (!line) w.drawing(chart(model, r, w));
}

void describe_critical(const Model& model, const StabilityReport& r, Writer& w) {
  const VariedParameter along = varied(model, r, 0, w);
  Table t{"critical",
          fmt::format("critical values, from {} verdicts between those of the grid", r.map->evaluations),
          {{"key"},
           {"value", varied(model, r, 0, w).title()},
           {"", r.varied.size() > 1 ? "at " + varied(model, r, 1, w).title() : ""},
           {"bracket"},
           {"from"},
           {"to"},
           {"", "what changes"},
           {"motions"},
           {"at"}},
          static_cast<Index>(r.map->critical.size()),
          {}};
  t.row = [&](Index k) {
    const CriticalValue& c = r.map->critical[static_cast<std::size_t>(k)];
    Json at = no_value;
    if (!c.others.empty()) at = {{r.varied[1], c.others[0]}};
    return std::vector<Cell>{{r.varied[c.axis]},
                             {c.value, determined(along.shown(c.value), along.shown(0.5 * (c.hi - c.lo)))},
                             {nullptr, c.others.empty() ? "" : fmt::format("{:.10g}", varied(model, r, 1, w).shown(c.others[0]))},
                             {{c.lo, c.hi}},
                             {verdict(c.from)},
                             {verdict(c.to)},
                             {nullptr, change_words(c.from, c.to)},
                             {{{"from", motions(c.from)}, {"to", motions(c.to)}}},
                             {at}};
  };
  w.table(t);
  if (r.map->critical.empty() && !r.map->interrupted) w.paragraph("no critical value between the points of the grid");
}

// Where there is no model, and why: the reason of the first such point.
void describe_missing(const StabilityReport& r, Writer& w) {
  const auto& cells = r.map->cells;
  const auto missing = std::count_if(cells.begin(), cells.end(), [](const auto& c) { return !c.point.law_kept; });
  if (missing == 0) return;
  const auto first = std::find_if(cells.begin(), cells.end(), [](const auto& c) { return !c.point.law_kept; });
  std::string where;
  for (std::size_t k = 0; k < r.varied.size(); ++k)
    where += fmt::format("{}{} = {:.10g}", k > 0 ? ", " : "", r.varied[k], first->values[k]);
  w.paragraph(fmt::format("no model at {} of {} points: at {} {}", missing, cells.size(), where, first->point.reason));
}

}  // namespace

void describe_map(const Model& model, const StabilityReport& r, Writer& w) {
  w.fact("varied", r.varied);
  describe_cells(model, r, w);
  describe_missing(r, w);
  describe_critical(model, r, w);
  if (r.map->interrupted) w.fact("interrupted", true, "interrupted", "cells without a verdict were not looked at");
  w.fact("evaluations", {{"cells", r.map->cells.size()}, {"between", r.map->evaluations}});
}

}  // namespace gyromode::io
