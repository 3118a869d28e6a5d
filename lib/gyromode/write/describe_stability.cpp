#include "gyromode/write/describe_map.h"
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
    words = fmt::format("roots of opposite energy sign come nearest at {:.10g} and {:.10g} {}, {:.3g} apart", w.frequency(a),
                        w.frequency(b), w.frequency_unit(), w.frequency(b - a));
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
           {{"", w.frequency_heading()}, {"", "energy"}, {"", "error bound", "{:.1e}"}, {"", "largest in"}},
           static_cast<Index>(modes.size()),
           [&](Index k) {
             const Mode& m = modes[static_cast<std::size_t>(k)];
             return std::vector<Cell>{{nullptr, determined(w.frequency(m.omega), w.frequency(m.error_bound))},
                                      {m.energy_sign < 0 ? "−" : "0: a pair of both signs"},
                                      {w.frequency(m.error_bound)},
                                      {nullptr, largest_in(model.labels(), m.shape)}};
           }});
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
  if (report.map) return describe_map(model, report, w);
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
