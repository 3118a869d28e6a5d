#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/roots/converge.h"
#include "gyromode/roots/divergence.h"
#include "gyromode/roots/static_count.h"
#include "gyromode/spectrum/inertia.h"

#include <optional>

namespace gyromode {

/// Where roots that do not follow the count may be: modes of negative energy and growing motions of an approximation of
/// the same system. They start iterations on the exact impedance; nothing is believed of them.
struct Seeds {
  std::vector<double> negative_energy;  ///< ω
  std::vector<Complex> growing;         ///< λ, positive real part, ω ≥ 0
};

/// The roots of a range, ascending.
struct RootsBetween {
  std::vector<Root> roots;
  double known_below = infinity;  ///< of work that was stopped: all roots below are known
};

/// The roots of an impedance with the proof that none is missing.
///
/// Where the static stiffness has no negative eigenvalue all energy is positive and the count J grows by one at every
/// root. Otherwise n₋ = k_r + 2k_c + 2k₋ (T12) must be met by roots found and verified one by one, growing ones and
/// those of negative energy, where J falls: then none of them is missing, and J with every fall taken back grows by one
/// at every root. Divergence and falls of J are looked for over all decades of σ and ω, for they may be as slow as a
/// verdict is near; what is then missing, flutter first of all, starts from seeds.
class CertifiedRoots {
 public:
  /// Seeds of one approximation after another, finer ones later: attempt 0, 1, …, until there are no more.
  using SeedSource = std::function<std::optional<Seeds>(Index attempt)>;
  /// `seeds` are asked for only where the static stiffness is indefinite, and as long as the roots found do not meet
  /// (T12).
  CertifiedRoots(const LiftedImpedance& impedance, const std::vector<Index>& free, const std::vector<Index>& cyclic, Index zeros,
                 const SeedSource& seeds);

  const BlockedImpedance& blocked() const { return blocked_; }
  const StaticCount& at_zero() const { return static_; }
  /// Whether J falls somewhere or motions grow: the static stiffness is indefinite.
  bool indefinite() const;
  bool asked_for_seeds() const { return asked_for_seeds_; }
  /// Of every block: reduced = k_r + 2k_c + 2k₋.
  bool closed() const;
  const std::vector<UnstableRoot>& growing() const { return growing_; }
  const std::vector<Root>& negative_energy() const { return negative_; }  ///< ascending

  /// All roots in [a, b), ascending, copies as entries of their own. `progress` is told "modes"; where it stops, those
  /// from some frequency on are left out.
  RootsBetween between(double a, double b, const Progress& progress = {}) const;
  /// Growing count at ω over all blocks and copies, less that at 0⁺.
  Index below(double omega) const;
  /// J(ω) over all blocks and copies; doubtful where a root is so near ω that the count is not beyond doubt.
  Inertia inertia_at(double omega) const;
  /// The growing count of a block, from its J at ω.
  Index growing_count(Index block, double omega, Index count) const;

 private:
  Index missing(Index block) const;
  void add(std::vector<Root> negative);
  void find_negative(const std::vector<double>& seeds);
  void find_growing(const std::vector<Complex>& seeds);

  BlockedImpedance blocked_;
  StaticCount static_;
  std::vector<Root> negative_;
  std::vector<UnstableRoot> growing_;
  bool asked_for_seeds_ = false;
};

}  // namespace gyromode
