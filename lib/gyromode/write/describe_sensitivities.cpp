#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode::io {

namespace {

// Of one root the parameters that move it most, by p/ω ∂ω/∂p.
std::vector<std::size_t> strongest(const std::vector<Sensitivity>& all, std::size_t root, double omega, std::size_t most) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (std::abs(all[i].relative(root, omega)) > 0) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::abs(all[a].relative(root, omega)) > std::abs(all[b].relative(root, omega));
  });
  order.resize(std::min(order.size(), most));
  return order;
}

Json over_roots(const std::vector<double>& values) {
  Json all = Json::array();
  for (const double v : values) all.push_back(std::isnan(v) ? Json(nullptr) : Json(v));
  return all;
}

}  // namespace

void describe_sensitivities(const std::vector<Sensitivity>& all, const std::vector<double>& omega, Writer& w) {
  constexpr std::size_t most = 4;
  if (all.empty()) return;
  std::vector<std::pair<std::size_t, std::size_t>> lines;  // root and parameter
  for (std::size_t root = 0; root < omega.size(); ++root) {
    for (const std::size_t i : strongest(all, root, omega[root], most)) lines.emplace_back(root, i);
  }
  w.table({"",
           "what moves each most",
           {{"", "#"}, {"", "parameter"}, {"", "value"}, {"", "p/ω ∂ω/∂p"}},
           static_cast<Index>(lines.size()),
           [&](Index k) {
             const auto& [root, i] = lines[static_cast<std::size_t>(k)];
             const bool first = k == 0 || lines[static_cast<std::size_t>(k - 1)].first != root;
             const Sensitivity& s = all[i];
             const std::string unit = s.parameter.dimension ? " " + std::string(unit_of(*s.parameter.dimension)) : "";
             return std::vector<Cell>{{nullptr, first ? fmt::format("{}", root + 1) : ""},
                                      {nullptr, s.parameter.key},
                                      {nullptr, fmt::format("{:.6g}{}", s.parameter.value, unit)},
                                      {nullptr, fmt::format("{:+.4g}", s.relative(root, omega[root]))}};
           }});
  w.table({"sensitivity",
           "",
           {{"key"}, {"value"}, {"unit"}, {"slope"}, {"relative"}, {"error"}, {"reason"}},
           static_cast<Index>(all.size()),
           [&](Index k) {
             const Sensitivity& s = all[static_cast<std::size_t>(k)];
             std::vector<double> relative;
             for (std::size_t root = 0; root < omega.size(); ++root) relative.push_back(s.relative(root, omega[root]));
             return std::vector<Cell>{{s.parameter.key},
                                      {s.parameter.value},
                                      {s.parameter.dimension ? Json(unit_of(*s.parameter.dimension)) : Json(nullptr)},
                                      {over_roots(s.slope)},
                                      {over_roots(relative)},
                                      {over_roots(s.error)},
                                      {s.reason.empty() ? no_value : Json(s.reason)}};
           }});
}

}  // namespace gyromode::io
