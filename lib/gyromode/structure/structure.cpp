#include "gyromode/structure/structure.h"

#include <algorithm>

namespace gyromode {

namespace {

Structure analysed(const CouplingGraph& graph) { return {partition(graph), graph.largest_ignored}; }

std::vector<Index> collected(const std::vector<Component>& components, std::vector<Index> Component::*group) {
  std::vector<Index> all;
  for (const Component& c : components) all.insert(all.end(), (c.*group).begin(), (c.*group).end());
  std::sort(all.begin(), all.end());
  return all;
}

// Entries off the diagonal up to tolerance · max |a| become zero.
Matrix thresholded(const Matrix& a, double tolerance) {
  const double limit = tolerance * a.cwiseAbs().maxCoeff();
  Matrix b = (a.cwiseAbs().array() <= limit).select(0.0, a);
  b.diagonal() = a.diagonal();
  return b;
}

}  // namespace

SystemClass Structure::system_class() const {
  return std::all_of(components.begin(), components.end(), [](const Component& c) { return c.quadrature(); }) ? SystemClass::quadrature
                                                                                                                : SystemClass::general;
}

std::vector<Index> Structure::in_phase() const { return collected(components, &Component::in_phase); }
std::vector<Index> Structure::in_quadrature() const { return collected(components, &Component::in_quadrature); }

std::optional<OddCycle> Structure::witness() const {
  for (const Component& c : components) {
    if (c.odd_cycle) return c.odd_cycle;
  }
  return std::nullopt;
}

Structure analyse(const System& system, const StructureOptions& options) {
  return analysed(coupling_graph({&system.mass(), &system.stiffness()}, system.gyroscopic(), options.coupling_tolerance));
}

Structure analyse(const FirstOrderSystem& system, const StructureOptions& options) {
  return analysed(coupling_graph({&system.inertia()}, system.gyroscopic(), options.coupling_tolerance));
}

System without_ignored_couplings(const System& system, const StructureOptions& options) {
  if (options.coupling_tolerance == 0) return system;
  const double tolerance = options.coupling_tolerance;
  return System(thresholded(system.mass(), tolerance), thresholded(system.gyroscopic(), tolerance), thresholded(system.stiffness(), tolerance),
                system.labels());
}

FirstOrderSystem without_ignored_couplings(const FirstOrderSystem& system, const StructureOptions& options) {
  if (options.coupling_tolerance == 0) return system;
  const double tolerance = options.coupling_tolerance;
  return FirstOrderSystem(thresholded(system.inertia(), tolerance), thresholded(system.gyroscopic(), tolerance), system.labels());
}

}  // namespace gyromode
