#include "gyromode/write/result_csv.h"

#include "gyromode/formats/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

double hertz(double omega) { return omega / (2 * std::numbers::pi); }

}  // namespace

std::string modes_csv(const Model& model, const ModesResult& r) {
  const bool shapes = (!r.modes.empty() && r.modes.front().shape.size() > 0) || (!r.unstable.empty() && r.unstable.front().shape.size() > 0);
  std::string out = "omega,frequency_hz,growth_rate,kind,energy_sign,multiplicity,residual,error_bound";
  if (shapes) {
    for (const std::string& label : model.labels()) out += fmt::format(",{},{}", csv_field(label + " re"), csv_field(label + " im"));
  }
  out += "\n";
  for (const Mode& m : r.modes) {
    out += fmt::format("{},{},0,{},{},{},{},{}", m.omega, hertz(m.omega), to_string(m.kind), m.energy_sign, m.multiplicity, m.residual, m.error_bound);
    for (const Complex& z : m.shape) out += fmt::format(",{},{}", z.real(), z.imag());
    out += "\n";
  }
  for (const UnstableMode& u : r.unstable) {
    const auto measured = [](double x) { return std::isfinite(x) ? fmt::format("{}", x) : std::string(); };
    out += fmt::format("{},{},{},{},,1,{},{}", u.omega, hertz(u.omega), u.growth_rate, u.flutter() ? "flutter" : "divergence", measured(u.residual), measured(u.error_bound));
    for (const Complex& z : u.shape) out += fmt::format(",{},{}", z.real(), z.imag());
    if (shapes && u.shape.size() == 0) out += std::string(static_cast<std::size_t>(2 * model.size()), ',');
    out += "\n";
  }
  return out;
}

std::string count_csv(const CountResult& r) {
  return fmt::format("from,to,count,signed,zero,negative_from,negative_to,status\n{},{},{},{},{},{},{},{}\n", r.window.a, r.window.b,
                     r.count ? fmt::format("{}", *r.count) : "", r.signed_count, r.zero, r.negative[0], r.negative[1], to_string(r.status));
}

std::string structure_csv(const Model& model, const StructureReport& report) {
  std::string out = "coordinate,component,group\n";
  for (std::size_t c = 0; c < report.structure.components.size(); ++c) {
    const Component& component = report.structure.components[c];
    for (const Index i : component.coordinates) {
      const auto& q = component.in_quadrature;
      const bool second = std::find(q.begin(), q.end(), i) != q.end();
      out += fmt::format("{},{},{}\n", csv_field(model.labels()[static_cast<std::size_t>(i)]), c + 1,
                         !component.quadrature() ? "mixed" : second ? "quadrature" : "in_phase");
    }
  }
  return out;
}

// The map where there is one, else the verdict.
std::string stability_csv(const StabilityReport& report) {
  if (report.map) {
    std::string out;
    for (const std::string& key : report.varied) out += csv_field(key) + ",";
    out += "stability,growth_rate,real_pairs,quadruples,negative_energy\n";
    for (const auto& [values, p] : report.map->cells) {
      for (const double v : values) out += fmt::format("{},", v);
      out += p.law_kept ? fmt::format("{},{},{},{},{}\n", to_string(p.stability), p.growth_rate, p.balance.real_pairs, p.balance.quadruples, p.balance.negative_energy) : "no_model,,,,\n";
    }
    return out;
  }
  const ModesResult& r = report.result;
  const IndexBalance& b = r.index_balance;
  return fmt::format("stability,negative,real_pairs,quadruples,negative_energy,zero,zero_negative,closed\n{},{},{},{},{},{},{},{}\n", to_string(r.stability),
                     b.negative, b.real_pairs, b.quadruples, b.negative_energy, b.zero, b.zero_negative, b.closed);
}

}  // namespace gyromode::io
