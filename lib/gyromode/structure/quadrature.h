#pragma once

#include "gyromode/structure/coupling.h"
#include "gyromode/structure/reversing_symmetry.h"

#include <memory>
#include <optional>
#include <vector>

namespace gyromode {

/// A closed walk v₀ → v₁ → … → v₀ with an odd number of cross couplings: why no quadrature partition exists.
/// kinds[k] is the coupling from coordinates[k] to coordinates[k + 1], the last one back to coordinates[0].
struct OddCycle {
  std::vector<Index> coordinates;
  std::vector<CouplingKind> kinds;
};

/// One connected component of the couplings. With a partition, T = diag(1, −j) makes its impedance real symmetric at every ω.
struct Component {
  std::vector<Index> coordinates;    ///< ascending
  std::vector<Index> in_phase;       ///< the group of the first coordinate; empty without a partition
  std::vector<Index> in_quadrature;  ///< the other group
  std::optional<OddCycle> odd_cycle; ///< the witness where there is no partition
  std::shared_ptr<const SymmetrySearch> search;  ///< where there is no partition and a reversing symmetry was looked for; rows in the order of `coordinates`

  bool quadrature() const { return !odd_cycle; }
  bool hidden_quadrature() const { return odd_cycle && search && search->found; }
};

/// Connected components and, for each, the quadrature partition of Boland & Janssens 1979, Eq. (8) or the witness that there is
/// none: a 2-colouring with parity in which in-phase couplings keep the colour and cross couplings change it
/// (theory (T3)). Every stored coupling is visited once a direction.
std::vector<Component> partition(const CouplingGraph& graph);

}  // namespace gyromode
