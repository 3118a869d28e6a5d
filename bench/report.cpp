#include "report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gyromode::bench {

std::string text(const Machine& m, const std::string& revision) {
  return fmt::format(
      "machine   {}, {} cores, {:.0f} GB, load {}\n"
      "software  gyromode {} ({}), {}, {}\n"
      "BLAS      {}, kernels {}, {} thread{}; LAPACK {}\n"
      "date      {}\n",
      m.cpu, m.cores, m.memory_gb, m.load, m.gyromode, revision, m.compiler, m.build, m.openblas, m.core, m.threads,
      m.threads == 1 ? "" : "s", m.lapack, m.date);
}

std::string text(const Row& row) {
  std::string out = fmt::format("\n{}  {}\n", row.key, row.title);
  if (!row.solver.empty()) out += fmt::format("   path: {}\n", row.solver);
  out += fmt::format("   {:<22}{:>12}{:>9}{:>12}   {:<18}(others used {:.0f} % of the machine)\n", "", "median", "spread", "ratio",
                     "round by round", 100 * row.others);
  for (std::size_t i = 0; i < row.timings.size(); ++i) {
    const Timing& t = row.timings[i];
    out += fmt::format("   {:<22}{:>9.2f} ms{:>7.1f} %", t.name, 1e3 * t.median(), 100 * t.spread());
    if (i > 0) {
      const Ratio r = ratio(row.timings[0], t);
      out += fmt::format("{:>12.3f}   {:.3f} to {:.3f}", r.of_medians, r.lowest, r.highest);
    }
    out += '\n';
  }
  return out;
}

std::string text(const std::vector<Score>& league) {
  std::string out = "\nAccuracy: residuals in units of n ε\n";
  out += fmt::format("   {:<18}{:<38}{:>5}{:>7}{:>10}{:>10}{:>12}\n", "", "", "n", "modes", "median", "worst", "|Re λ|");
  for (const Score& s : league) {
    out += fmt::format("   {:<18}{:<38}{:>5}{:>7}{:>10.2g}{:>10.2g}{:>12}\n", s.system, s.method, s.order, s.modes, s.median, s.worst,
                       s.real_part ? fmt::format("{:.1e}", *s.real_part) : "flutter");
  }
  return out;
}

namespace {

using Json = nlohmann::ordered_json;

Json json(const Machine& m) {
  return {{"cpu", m.cpu},           {"cores", m.cores},   {"memory_gb", m.memory_gb}, {"load", m.load},
          {"compiler", m.compiler}, {"build", m.build},   {"openblas", m.openblas},   {"kernels", m.core},
          {"threads", m.threads},   {"lapack", m.lapack}, {"gyromode", m.gyromode},   {"date", m.date}};
}

Json json(const Row& row) {
  Json contestants = Json::array();
  for (const Timing& t : row.timings) {
    contestants.push_back(
        {{"name", t.name}, {"options", t.options}, {"median_s", t.median()}, {"spread", t.spread()}, {"seconds", t.seconds}});
  }
  Json ratios = Json::array();
  for (std::size_t i = 1; i < row.timings.size(); ++i) {
    const Ratio r = ratio(row.timings[0], row.timings[i]);
    ratios.push_back({{"of", row.timings[0].name},
                      {"to", row.timings[i].name},
                      {"of_medians", r.of_medians},
                      {"lowest", r.lowest},
                      {"highest", r.highest}});
  }
  return {{"row", row.key},       {"title", row.title},         {"path", row.solver},
          {"others", row.others}, {"contestants", contestants}, {"ratios", ratios}};
}

Json json(const Score& s) {
  return {{"system", s.system},
          {"method", s.method},
          {"order", s.order},
          {"modes", s.modes},
          {"median_n_eps", s.median},
          {"worst_n_eps", s.worst},
          {"real_part", s.real_part ? Json(*s.real_part) : Json()}};
}

template <class Part>
Json list_of(const std::vector<Part>& parts) {
  Json list = Json::array();
  for (const Part& part : parts) list.push_back(json(part));
  return list;
}

}  // namespace

Json json(const Report& report) {
  return {{"schema", "gyromode/bench/1"},
          {"revision", report.revision},
          {"machine", json(report.machine)},
          {"options",
           {{"n_scale", report.options.n_scale}, {"rounds", report.options.rounds}, {"process_rounds", report.options.process_rounds}}},
          {"rows", list_of(report.rows)},
          {"accuracy", list_of(report.accuracy)}};
}

}  // namespace gyromode::bench
