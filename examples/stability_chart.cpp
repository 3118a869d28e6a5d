// A stability chart: gyroscopic stabilisation of a mass on a hill, and the thresholds where it begins.
//
// 1 kg on a hill of curvatures −k₁, −k₂, held by a gyroscopic force g: M = 1, G = g [0 −1; 1 0], K = −diag(k₁, k₂)
// (Thomson & Tait, Natural Philosophy, §345). With s = g² − k₁ − k₂ the roots are λ² = [−s ± √(s² − 4k₁k₂)]/2, so that
// the mass
//     rolls off (divergence)            for g < |√k₁ − √k₂|,
//     spirals out (flutter)             up to g = √k₁ + √k₂, at the rate ½√((√k₁ + √k₂)² − g²),
//     stays (gyroscopically stabilised) beyond; there the frequencies differ by √(g² − (√k₁ + √k₂)²), energies of opposite sign.
#include "comparison.h"

#include <gyromode/gyromode.h>

using namespace gyromode;

constexpr double k1 = 1;  // N/m

System on_a_hill(double g, double k2) { return {Matrix::Identity(2, 2), Matrix{{0, -g}, {g, 0}}, Matrix{{-k1, 0}, {0, -k2}}}; }

StabilityPoint verdict(double g, double k2) {
  const ModesResult result = find_modes(on_a_hill(g, k2));
  return stability_point(result);
}

char letter(const StabilityPoint& p) {
  if (p.balance.real_pairs > 0) return 'd';
  if (p.balance.quadruples > 0) return 'f';
  return p.stability == Stability::gyroscopically_stabilised ? 's' : '?';
}

std::vector<double> grid(double from, double to, int points) {
  std::vector<double> values;
  for (int i = 0; i < points; ++i) values.push_back(from + (to - from) * i / (points - 1));
  return values;
}

int main() {
  Comparison check;
  std::printf("k₂ from 0.5 (top) to 9 N/m, g from 0.05 to 6.05 kg/s: d divergence, f flutter, s gyroscopically stabilised\n");
  const auto at = [](const std::vector<double>& v) { return verdict(v[0], v[1]); };
  const StabilityMap chart = map_stability(at, {grid(0.05, 6.05, 61), grid(0.5, 9, 12)});
  bool as_exact = true;
  for (std::size_t i = 0; i < chart.cells.size(); ++i) {
    const double g = chart.cells[i].values[0], root1 = std::sqrt(k1), root2 = std::sqrt(chart.cells[i].values[1]);
    const char found = letter(chart.cells[i].point);
    as_exact = as_exact && found == (g < std::abs(root1 - root2) ? 'd' : g < root1 + root2 ? 'f' : 's');
    std::printf("%c%s", found, (i + 1) % chart.axes[0].size() == 0 ? "\n" : "");
  }
  check.holds("every cell is what the closed form says", as_exact);

  std::printf("Critical values of g [kg/s], bisected, and their closed forms\n");
  check.equal("thresholds found", static_cast<double>(chart.critical.size()), 24, 0);
  for (const CriticalValue& c : chart.critical) {
    const double k2 = c.others[0], sign = c.to.stability == Stability::gyroscopically_stabilised ? 1 : -1;
    check.equal(sign > 0 ? "flutter ends" : "divergence becomes flutter", c.value, std::abs(std::sqrt(k1) + sign * std::sqrt(k2)), 1e-10);
  }

  std::printf("k₂ = 4 N/m: growth below the threshold of 3 kg/s, margins above it\n");
  check.equal("growth rate at g = 2.5 kg/s [1/s]", verdict(2.5, 4).growth_rate, 0.5 * std::sqrt(9 - 2.5 * 2.5), 1e-13);
  const StabilityReport report = Model(on_a_hill(3.1, 4)).stability();
  const auto pair = report.opposite.value();
  check.equal("distance of the opposite pair at g = 3.1 kg/s [rad/s]", pair[1] - pair[0], std::sqrt(3.1 * 3.1 - 9), 1e-13);
  check.equal("K nearest to zero [rad²/s²]", report.stiffness.value(), -k1, 1e-14);
  return check.exit_code();
}
