#include "gyromode/write/result_text.h"
#include "gyromode/write/text_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode::io {

namespace {

// What damping D > 0 at rest in the axes of the model makes of it: as many growing roots as K has negative eigenvalues, K singular or not (Kelvin, Tait, Chetaev; Zajac 1964; theory §5).
std::string damping_words(const ModesResult& r) {
  const Index growing = r.index_balance.negative;
  if (r.first_order) return "not a part of first-order models";
  if (growing == 0) return "that is at rest in these axes makes every vibration decay";
  return fmt::format("that is at rest in these axes leaves {} growing, as K has {} negative{}", growing == 1 ? "1 root" : fmt::format("{} roots", growing), growing,
                     r.negative_modes.empty() ? "" : fmt::format(": each mode of negative energy grows ({})", r.negative_modes.size()));
}

std::string largest_in(const Model& model, const ComplexVector& shape) {
  if (shape.size() == 0) return "";
  Index at = 0;
  shape.cwiseAbs().maxCoeff(&at);
  return model.labels()[static_cast<std::size_t>(at)];
}

std::string negative_table(const Model& model, const std::vector<Mode>& modes, Format format) {
  Grid grid({"ω [rad/s]", "energy", "error bound", "largest in"});
  for (const Mode& m : modes) grid.add({fmt::format("{:.15g}", m.omega), m.energy_sign < 0 ? "−" : "0: a pair of both signs", fmt::format("{:.1e}", m.error_bound), largest_in(model, m.shape)});
  return written(grid, format);
}

std::string growing_table(const Model& model, const std::vector<UnstableMode>& modes, Format format) {
  Grid grid({"growth rate [1/s]", "ω [rad/s]", "error bound", "kind", "largest in"});
  for (const UnstableMode& u : modes) {
    grid.add({fmt::format("{:.15g}", u.growth_rate), fmt::format("{:.15g}", u.omega), measured(u.error_bound), u.flutter() ? "flutter" : "divergence", largest_in(model, u.shape)});
  }
  return written(grid, format);
}

std::string verdict_word(const StabilityPoint& p) { return p.law_kept ? std::string(to_string(p.stability)) : "no model"; }

// Beside one with the same verdict the numbers that tell them apart.
std::string verdict_beside(const StabilityPoint& p, const StabilityPoint& other) {
  if (p.stability != other.stability) return verdict_word(p);
  return fmt::format("{}: {} divergent, {} flutter, {} of negative energy", verdict_word(p), p.balance.real_pairs, p.balance.quadruples, p.balance.negative_energy);
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
  std::string out = fmt::format("\n{} upwards, {} to the right\n", r.varied[1], r.varied[0]);
  for (std::size_t j = across.size(); j-- > 0;) {
    out += fmt::format("{:>12.6g} ", across[j]);
    for (std::size_t i = 0; i < along.size(); ++i) out += letter(r.map->cells[j * along.size() + i].point);
    out += "\n";
  }
  const std::string last = fmt::format("{:.6g}", along.back()), first = fmt::format("{:.6g}", along.front());
  out += fmt::format("{:>13}{}{}{}\n", "", first, std::string(along.size() > first.size() + last.size() ? along.size() - first.size() - last.size() : 1, ' '), last);
  return out + "s stable, g gyroscopically stabilised, D divergence, F flutter, m marginal, ? unknown, blank: no such model\n";
}

std::string line_of_map(const StabilityReport& r, Format format) {
  Grid grid({r.varied[0], "verdict", "growth rate [1/s]", "divergent", "flutter", "negative energy"});
  for (const auto& [values, p] : r.map->cells) {
    grid.add({fmt::format("{:.10g}", values[0]), verdict_word(p), p.law_kept ? fmt::format("{:.6g}", p.growth_rate) : "", fmt::format("{}", p.balance.real_pairs),
              fmt::format("{}", p.balance.quadruples), fmt::format("{}", p.balance.negative_energy)});
  }
  return "\n" + written(grid, format);
}

std::string critical_table(const StabilityReport& r, Format format) {
  std::vector<std::string> head{r.varied[0]};
  if (r.varied.size() > 1) head.push_back("at " + r.varied[1]);
  head.insert(head.end(), {"bracket", "from", "to"});
  Grid grid(head);
  for (const CriticalValue& c : r.map->critical) {
    std::vector<std::string> row{fmt::format("{:.15g}", c.value)};
    for (const double v : c.others) row.push_back(fmt::format("{:.10g}", v));
    row.insert(row.end(), {fmt::format("{:.1e} wide", c.hi - c.lo), verdict_beside(c.from, c.to), verdict_beside(c.to, c.from)});
    grid.add(std::move(row));
  }
  if (grid.empty()) return "\nno critical value between the points of the grid\n";
  return fmt::format("\ncritical values, from {} verdicts between those of the grid\n", r.map->evaluations) + written(grid, format);
}

}  // namespace

std::string stability_text(const Model& model, const StabilityReport& report, Format format) {
  const ModesResult& r = report.result;
  std::string out = heading(format, model_line(model));
  out += fact(format, "stability", stability_words(r.stability));
  if (!r.first_order) {
    out += fact(format, "stiffness", stiffness_words(r.stiffness));
    out += fact(format, "balance", balance_words(r.index_balance));
    out += fact(format, "damping", damping_words(r));
  }
  if (report.opposite) {
    out += fact(format, "margin", fmt::format("roots of opposite energy sign come nearest at {:.10g} and {:.10g} rad/s, {:.3g} apart", (*report.opposite)[0], (*report.opposite)[1],
                                              (*report.opposite)[1] - (*report.opposite)[0]));
  } else if (std::isfinite(r.opposite_gap)) {
    out += fact(format, "margin", fmt::format("nearest roots of opposite energy sign are {:.3g} apart, relative", r.opposite_gap));
  }
  if (report.stiffness) out += fact(format, "", fmt::format("the eigenvalue of (K, M) nearest to zero is {:.6g} rad²/s²", *report.stiffness));
  if (!r.negative_modes.empty()) out += "\nmodes of negative energy\n" + negative_table(model, r.negative_modes, format);
  if (!r.unstable.empty()) out += "\n" + growing_table(model, r.unstable, format);
  if (report.map) out += (report.varied.size() > 1 ? chart(report) : line_of_map(report, format)) + critical_table(report, format);
  return out;
}

}  // namespace gyromode::io
