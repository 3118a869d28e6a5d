#pragma once

#include "gyromode/base/types.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

struct SymmetrySearch;

/// How two coordinates are coupled: `in_phase` through M or K (real entries of H), `cross` through G (imaginary
/// entries).
enum class CouplingKind : std::uint8_t { in_phase, cross };

/// A closed walk v₀ → v₁ → … → v₀ with an odd number of cross couplings: why no quadrature partition exists.
/// kinds[k] is the coupling from coordinates[k] to coordinates[k + 1], the last one back to coordinates[0].
struct OddCycle {
  std::vector<Index> coordinates;   ///< v₀, v₁, …
  std::vector<CouplingKind> kinds;  ///< of the couplings along the walk
};

/// One connected component of the couplings. With a partition, T = diag(1, −j) makes its impedance real symmetric at
/// every ω.
struct Component {
  std::vector<Index> coordinates;     ///< ascending
  std::vector<Index> in_phase;        ///< the group of the first coordinate; empty without a partition
  std::vector<Index> in_quadrature;   ///< the other group
  std::optional<OddCycle> odd_cycle;  ///< the witness where there is no partition
  /// where there is no partition and a reversing symmetry was looked for; rows in the order of `coordinates`
  std::shared_ptr<const SymmetrySearch> search;

  /// where there is no partition: a symmetry of the mesh that reverses the spin was shown
  bool mesh_symmetry = false;

  bool quadrature() const { return !odd_cycle; }  ///< whether it has a partition
  bool hidden_quadrature() const;                 ///< no partition, but a reversing symmetry
};

/// The class that decides which solver serves a system (theory §1–3).
enum class SystemClass { quadrature, hidden_quadrature, general };
std::string_view to_string(SystemClass c);

/// Whether a reversing symmetry is looked for where the coordinates show no partition. `by_cost`: at any order where K
/// is not positive definite, as the general solver then costs five to fourteen times the search; where K is, the
/// general solver is faster than the search alone, and it is looked for up to order 256 only, where it takes hundredths
/// of a second, so as to be known (bench/results).
enum class HiddenSearch { by_cost, always, never };

/// What is known of a system before it is solved.
struct Structure {
  std::vector<Component> components;  ///< of the couplings

  /// quadrature where every component has a partition; hidden where the others have a reversing symmetry
  SystemClass system_class() const;
  std::vector<Index> in_phase() const;       ///< coordinates, ascending, over all components
  std::vector<Index> in_quadrature() const;  ///< likewise
  std::optional<OddCycle> witness() const;   ///< the first component's odd cycle where there is no partition
};

/// What is known of a system.
Structure analyse(const System& system, HiddenSearch hidden = HiddenSearch::by_cost);
Structure analyse(const FirstOrderSystem& system);

/// Couplings that somebody asked to leave out: a_ij, i ≠ j, with |a_ij| ≤ tolerance · max |a|, in each of M, G, K (I,
/// G) by itself.
struct IgnoredCouplings {
  double tolerance = 0;  ///< as asked
  double largest = 0;    ///< of those left out, |a_ij| / max |a|; 0 where none was small enough
};

/// "couplings up to 0.01 of the largest entry of their matrix are left out, as asked: the largest of them is 0.0025".
std::string in_words(const IgnoredCouplings& ignored);

}  // namespace gyromode
