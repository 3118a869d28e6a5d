#include "gyromode/refinement/polish.h"

#include "gyromode/refinement/correct.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/refinement/correct_shapes.h"
#include "gyromode/dense/refinement/refine.h"

#include <algorithm>

namespace gyromode {

namespace {

// Runs of neighbours whose error intervals touch; those with a poor residual among them.
std::vector<std::vector<Index>> poor_groups(const Spectrum& s, const Assessment& a, double enough) {
  std::vector<std::vector<Index>> groups;
  std::vector<Index> run;
  bool poor = false;
  double reach = 0;
  for (Index i = 0; i <= s.omega.size(); ++i) {
    const bool ends = i == s.omega.size() || run.empty() || s.omega(i) - 4 * a.error_bound(i) > reach;
    if (ends && !run.empty()) {
      if (poor) groups.push_back(run);
      run.clear();
      poor = false;
      reach = 0;
    }
    if (i == s.omega.size()) break;
    run.push_back(i);
    poor = poor || !(a.own_residual(i) <= enough);
    reach = std::max(reach, s.omega(i) + 4 * a.error_bound(i));
  }
  return groups;
}

// Of a large system all poor shapes are corrected at once, by products; what that leaves poor is refined root by root.
void correct_at_once(const dense::Impedance& h, Spectrum& s, Assessment& a, double enough) {
  constexpr int passes = 2;
  for (int pass = 0; pass < passes; ++pass) {
    const auto poor = [&](const Vector& residual) {
      std::vector<Index> at;
      for (Index i = 0; i < residual.size(); ++i) {
        if (!(residual(i) <= enough)) at.push_back(i);
      }
      return at;
    };
    const std::vector<Index> modes = poor(a.own_residual), unstable = poor(a.unstable.own_residual);
    if (modes.empty() && unstable.empty()) return;
    Spectrum next = s;
    dense::correct_shapes(h, next, modes, unstable);
    Assessment measured = correct(h, next);
    if (poor(measured.own_residual).size() + poor(measured.unstable.own_residual).size() >= modes.size() + unstable.size()) return;
    s = std::move(next);
    a = std::move(measured);
  }
}

}  // namespace

void polish(const dense::Impedance& h, Spectrum& s, Assessment& a, Index most) {
  const double n = static_cast<double>(s.size());
  // beyond, what a certificate asks for is enough, and only so many factorisations as a second or two allow
  const bool small = s.size() <= 64;
  const double enough = (small ? 1 : 6) * backward_error(s.size());
  if (!small && h.second_order()) correct_at_once(h, s, a, enough);
  if (!small) most = std::min(most, static_cast<Index>(std::max(4.0, 4e6 / (n * n))));
  // a refined neighbour shrinks its interval, and a group may fall apart into roots that can be told from each other
  constexpr int rounds = 3;
  for (int round = 0; round < rounds; ++round) {
    bool changed = false;
    for (const auto& group : poor_groups(s, a, enough)) {
      if (most-- <= 0) break;
      double reach = 0;
      for (const Index i : group) reach = std::max(reach, 4 * a.error_bound(i));
      reach += s.omega(group.back()) - s.omega(group.front());
      changed = dense::refine(h, s, group, reach) || changed;
    }
    if (!changed) return;
    sort_by_frequency(s);
    a = measure(h, s);
  }
}

}  // namespace gyromode
