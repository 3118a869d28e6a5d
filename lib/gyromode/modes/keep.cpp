#include "gyromode/modes/keep.h"

#include "gyromode/dense/inertia.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/local_modes.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

std::vector<Index> all_but(Index n, const std::vector<Index>& kept) {
  std::vector<Index> rest;
  for (Index i = 0; i < n; ++i) {
    if (std::find(kept.begin(), kept.end(), i) == kept.end()) rest.push_back(i);
  }
  return rest;
}

// The modes of each component by position in `modes`, in runs of neighbours that shapes may not tell apart.
std::vector<std::vector<std::vector<Mode*>>> neighbours(std::vector<Mode>& modes, const Structure& structure, Index n) {
  constexpr double apart = 1e-6;  // relative: what is nearer is looked at together, and told apart by C (modes/local_modes.h)
  std::vector<std::size_t> component(static_cast<std::size_t>(n));
  for (std::size_t c = 0; c < structure.components.size(); ++c) {
    for (const Index i : structure.components[c].coordinates) component[static_cast<std::size_t>(i)] = c;
  }
  std::vector<std::vector<std::vector<Mode*>>> runs(structure.components.size());
  for (Mode& m : modes) {
    if (m.kind != ModeKind::vibration) continue;
    Index largest = 0;
    m.shape.cwiseAbs().maxCoeff(&largest);
    auto& of = runs[component[static_cast<std::size_t>(largest)]];
    if (of.empty() || !(m.omega - of.back().back()->omega <= apart * m.omega)) of.emplace_back();
    of.back().push_back(&m);
  }
  return runs;
}

// A component without kept coordinates moves by itself: all its modes are local.
void mark_local(std::vector<Mode>& modes, const System& system, const Structure& structure, const std::vector<Index>& kept) {
  const auto runs = neighbours(modes, structure, system.size());
  for (std::size_t c = 0; c < runs.size(); ++c) {
    const auto& coordinates = structure.components[c].coordinates;
    const auto is_kept = [&](Index i) { return std::find(kept.begin(), kept.end(), i) != kept.end(); };
    const Index seen = std::count_if(coordinates.begin(), coordinates.end(), is_kept);
    if (seen == static_cast<Index>(coordinates.size()) || runs[c].empty()) continue;
    if (seen == 0) {
      for (const auto& run : runs[c]) {
        for (Mode* m : run) m->kind = ModeKind::local;
      }
      continue;
    }
    const ComponentSeenFrom component(system, structure.components[c], kept);
    for (const auto& run : runs[c]) {
      if (run.front()->omega > 0) component.mark_local(run);
    }
  }
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
    const ComplexMatrix condensed = border.adjoint() * small::solve(internal, border);
    r.reduced -= 0.5 * (condensed + condensed.adjoint());
  }
  r.kept = inertia(r.reduced);
  return r;
}

ModesResult find_modes_keeping(const System& system, const std::vector<Index>& kept, const ModesOptions& options) {
  ModesOptions with_shapes = options;
  with_shapes.keep.clear();
  with_shapes.shapes = true;
  ModesResult r = find_modes(system, with_shapes);
  mark_local(r.modes, system, r.structure, kept);
  const auto local = std::count_if(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.kind == ModeKind::local; });
  if (!options.shapes) {
    for (std::vector<Mode>* modes : {&r.modes, &r.negative_modes}) {
      for (Mode& m : *modes) {
        m.shape.resize(0);
        m.form = 0;
      }
    }
    for (UnstableMode& u : r.unstable) u.shape.resize(0);
  }
  r.solver += fmt::format("; seen from {} of {} coordinates, {} of these modes local", kept.size(), system.size(), local);
  return r;
}

}  // namespace gyromode
