#pragma once

#include "gyromode/modes/sparse_balance.h"
#include "gyromode/modes/sparse_modes.h"
#include "gyromode/spectrum/inertia.h"

#include <map>

namespace gyromode {

/// n₋(H(ω)) of a sparse system by factorisations, each done once, and how many modes windows hold by that.
class SparseCounts {
 public:
  SparseCounts(const SparseSystem& system, const sparse::Searches& searches, const SparseBalance& balance)
      : system_(system), searches_(searches), balance_(balance) {}

  Inertia at(double omega) const;
  /// n₋(H(0⁺)).
  Index at_zero() const { return searches_.negative_stiffness() + searches_.free().more_at_zero(); }
  /// How far H(ω) is from singular.
  double margin(double omega) const;
  /// Modes in (a, b).
  Index between(double a, double b) const;
  /// About the middle of a window, where no mode is.
  double middle_of(double a, double b) const;
  /// A frequency a little above that is none of a mode.
  double clear_of_roots(double omega) const;

  /// From now on those, ascending, are all modes of a window with n₋(H) = `negative` at its beginning, as something
  /// else has shown: no factorisation is needed in it.
  void know(const Window& window, Index negative, const SparseModes& modes);
  /// That window; empty where nothing is known.
  const Window& known() const { return known_; }

 private:
  const SparseSystem& system_;
  const sparse::Searches& searches_;
  const SparseBalance& balance_;
  struct Counted {
    Inertia inertia;
    double margin = 0;  // of the factorisation
  };
  mutable std::map<double, Counted> counted_;
  Window known_{0, 0};
  Index known_negative_ = 0;  // n₋(H) at its beginning
  SparseModes in_known_;      // its modes, without shapes
};

}  // namespace gyromode
