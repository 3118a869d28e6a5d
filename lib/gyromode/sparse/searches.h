#pragma once

#include "gyromode/sparse/known_motions.h"
#include "gyromode/sparse/search.h"
#include "gyromode/sparse/shifted.h"
#include "gyromode/sparse/stiffness.h"
#include "gyromode/sparse/free_motions.h"

#include <memory>
#include <string>

namespace gyromode::sparse {

/// The searches that a system admits, each by the operator that fits it best, with the factorisations they share.
class Searches {
 public:
  /// K is factored. @throws TooLarge; NotApplicable where K is singular and what is free cannot be told
  Searches(const SparseSystem& system, const Structure& structure);

  const Groups& groups() const { return groups_; }
  const Norms& norms() const { return norms_; }
  const StiffnessFactors& stiffness() const { return stiffness_; }
  const FreeMotions& free() const { return free_; }
  /// n₋(K), and n₋(H(ω)) of ω > 0, of what is not left out as free.
  Index negative_stiffness() const { return stiffness_.negative() - free_.t.cols(); }
  Index negative_at(double omega) const { return impedance(omega)->negative - free_.t.cols(); }
  /// H(ω) of ω > 0, factored.
  std::shared_ptr<const ShiftedFactor> impedance(double omega) const { return impedance_.at(omega); }
  /// About a shift, σ = 0 being K, or where that is singular a frequency below the others; `wanted`: about how many
  /// roots will be asked for.
  std::unique_ptr<Search> about(double sigma, Index wanted) const;
  /// All motions that the energy is not positive on: searches from now on leave them aside, where K is of neither sign
  /// in both blocks, and are as fast as of K > 0.
  void know(KnownMotions motions);
  /// From now on they leave nothing aside: slower, and of another kind where that failed. False where nothing was.
  bool leave_nothing_aside() const;
  /// The one about 0, which goes on where it was left.
  Search& about_zero(Index wanted) const;
  /// Forgets it: it makes room.
  void release_zero() const { at_zero_.reset(); }
  /// Forgets also the factors of K, which are made again where they are needed.
  void release_stiffness() const {
    release_zero();
    stiffness_.release();
  }
  /// Which operator that is, for people.
  std::string in_words() const;

 private:
  Index negative(Index block) const;
  /// The block of K that is positive semidefinite, definite where there is one, or −1.
  Index leading_block() const;
  double lowest_shift() const;
  /// The operator about a shift, 0 being K, without free motions; `first`: the block of K that it begins with.
  std::unique_ptr<Inverse> inverse_about(double sigma, Index first) const;
  /// The same without the motions that are known; null where these are none, or do not serve.
  std::unique_ptr<Inverse> inverse_beside_known(double sigma) const;

  const SparseSystem& system_;
  Groups groups_;
  Norms norms_;
  StiffnessFactors stiffness_;
  FreeMotions free_;
  ShiftedImpedance impedance_;
  KnownMotions known_;
  mutable States known_states_;  // in the order of coordinates; of no columns where they do not serve
  Index known_leads_ = 0;
  mutable std::unique_ptr<Search> at_zero_;
};

}  // namespace gyromode::sparse
