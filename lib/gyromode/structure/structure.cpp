#include "gyromode/structure/structure.h"

#include "gyromode/structure/quadrature.h"
#include "gyromode/structure/reversing_symmetry.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include "gyromode/lapack/triangular.h"
#include "gyromode/system/scale.h"

#include <algorithm>

namespace gyromode {

namespace {

bool positive_definite(const Matrix& k) {
  if (!(k.diagonal().array() > 0).all()) return false;
  Matrix l = scaled(k, unit_diagonal_scale(k));
  return !lapack::cholesky(l);
}

bool worth_a_search(const Matrix& stiffness, HiddenSearch choice) {
  constexpr Index unnoticed = 256;
  if (choice != HiddenSearch::by_cost) return choice == HiddenSearch::always;
  return stiffness.rows() <= unnoticed || !positive_definite(stiffness);
}

// Beyond this order, where only cost counts, an invariant is asked before the search.
constexpr std::size_t unnoticed_search = 64;

std::vector<Index> collected(const std::vector<Component>& components, std::vector<Index> Component::*group) {
  std::vector<Index> all;
  for (const Component& c : components) all.insert(all.end(), (c.*group).begin(), (c.*group).end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

bool Component::hidden_quadrature() const { return odd_cycle && (mesh_symmetry || (search && search->found)); }

std::string_view to_string(SystemClass c) {
  switch (c) {
    case SystemClass::quadrature: return "quadrature";
    case SystemClass::hidden_quadrature: return "hidden_quadrature";
    default: return "general";
  }
}

SystemClass Structure::system_class() const {
  const auto all = [&](auto&& has) { return std::all_of(components.begin(), components.end(), has); };
  if (all([](const Component& c) { return c.quadrature(); })) return SystemClass::quadrature;
  return all([](const Component& c) { return c.quadrature() || c.hidden_quadrature(); }) ? SystemClass::hidden_quadrature
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

Structure analyse(const System& system, HiddenSearch hidden) {
  Structure s{partition(coupling_graph({&system.mass(), &system.stiffness()}, system.gyroscopic()))};
  if (hidden == HiddenSearch::never || s.system_class() == SystemClass::quadrature) return s;
  for (Component& c : s.components) {
    if (c.quadrature()) continue;
    const auto& at = c.coordinates;
    const Matrix stiffness = system.stiffness()(at, at);
    if (worth_a_search(stiffness, hidden))
      c.search = std::make_shared<SymmetrySearch>(
          find_reversing_symmetry(system.mass()(at, at), system.gyroscopic()(at, at), stiffness,
                                  hidden == HiddenSearch::by_cost && c.coordinates.size() > unnoticed_search));
  }
  return s;
}

Structure analyse(const FirstOrderSystem& system) { return {partition(coupling_graph({&system.inertia()}, system.gyroscopic()))}; }

}  // namespace gyromode
