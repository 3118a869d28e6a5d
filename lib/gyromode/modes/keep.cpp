#include "gyromode/modes/keep.h"

#include "gyromode/modes/shape.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

std::vector<Index> all_but(Index n, const std::vector<Index>& kept) {
  std::vector<Index> rest;
  for (Index i = 0; i < n; ++i) {
    if (std::find(kept.begin(), kept.end(), i) == kept.end()) rest.push_back(i);
  }
  return rest;
}

// Where a mode may be, at most a millionth off.
double open_error(const Mode& m) { return std::clamp(std::isfinite(m.error_bound) ? m.error_bound : m.omega, 8 * epsilon * m.omega, 1e-6 * m.omega); }

// Modes that rounding does not tell apart, by position in `modes`.
std::vector<std::vector<std::size_t>> coinciding(const std::vector<Mode>& modes) {
  std::vector<std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const bool together = !groups.empty() && modes[i].kind == ModeKind::vibration && modes[groups.back().back()].kind == ModeKind::vibration &&
                          modes[i].energy_sign == modes[groups.back().back()].energy_sign &&
                          modes[i].omega - modes[groups.back().back()].omega <= 4 * (open_error(modes[i]) + open_error(modes[groups.back().back()]));
    if (together) groups.back().push_back(i);
    else groups.push_back({i});
  }
  return groups;
}

// Coinciding modes as combinations of which the first move the kept coordinates and the last do not, as far as singular values tell.
void part(std::vector<Mode>& modes, const std::vector<std::size_t>& group, const std::vector<Index>& kept) {
  if (group.size() == 1) return;
  ComplexMatrix x(modes[group[0]].shape.size(), static_cast<Index>(group.size()));
  for (std::size_t k = 0; k < group.size(); ++k) x.col(static_cast<Index>(k)) = modes[group[k]].shape.normalized();
  const Eigen::JacobiSVD<ComplexMatrix> svd(x(kept, Eigen::all), Eigen::ComputeFullV);
  const ComplexMatrix turned = x * svd.matrixV();
  for (std::size_t k = 0; k < group.size(); ++k) modes[group[k]].shape = normalised(turned.col(static_cast<Index>(k)));
}

// Of a mode that hardly moves the kept coordinates: whether n₋(H_red) stays as it is across it.
bool counted_local(const System& system, const std::vector<Index>& kept, const Mode& m, Index coinciding) {
  const double beside = 64 * open_error(m);
  const ReducedImpedance below = reduced_impedance(system, kept, m.omega - beside), above = reduced_impedance(system, kept, m.omega + beside);
  return std::abs(above.internal.negative - below.internal.negative) >= 1 && std::abs(above.kept.negative - below.kept.negative) < coinciding;
}

}  // namespace

ReducedImpedance reduced_impedance(const System& system, const std::vector<Index>& kept, double omega) {
  const ComplexMatrix h = system.impedance(omega);
  const std::vector<Index> rest = all_but(system.size(), kept);
  const ComplexMatrix border = h(rest, kept), internal = h(rest, rest);
  ReducedImpedance r;
  r.reduced = h(kept, kept);
  if (!rest.empty()) {
    r.internal = inertia(internal);
    if (r.internal.doubtful()) {  // at a pole
      r.kept.margin = 0;
      return r;
    }
    const ComplexMatrix condensed = border.adjoint() * internal.partialPivLu().solve(border);
    r.reduced -= 0.5 * (condensed + condensed.adjoint());
  }
  r.kept = inertia(r.reduced);
  return r;
}

ModesResult find_modes_keeping(const System& system, const std::vector<Index>& kept, const ModesOptions& options) {
  ModesOptions with_shapes = options;
  with_shapes.shapes = true;
  ModesResult r = find_modes(system, with_shapes);
  constexpr double hardly = 1e-6;
  Index local = 0;
  for (const auto& group : coinciding(r.modes)) {
    part(r.modes, group, kept);
    for (const std::size_t k : group) {
      Mode& m = r.modes[k];
      if (m.kind != ModeKind::vibration || m.omega == 0) continue;
      const bool at_rest = m.shape(kept).cwiseAbs().maxCoeff() <= hardly;
      if (!at_rest || !counted_local(system, kept, m, static_cast<Index>(group.size()))) continue;
      m.kind = ModeKind::local;
      m.shape(kept).setZero();
      ++local;
    }
  }
  if (!options.shapes) {
    for (Mode& m : r.modes) m.shape.resize(0);
  }
  r.path += fmt::format("; seen from {} of {} coordinates, {} of these modes local", kept.size(), system.size(), local);
  return r;
}

}  // namespace gyromode
