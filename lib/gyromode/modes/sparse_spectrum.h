#pragma once

#include "gyromode/modes/sparse_counts.h"
#include "gyromode/spectrum/counted_spectrum.h"

#include <string>

namespace gyromode {

/// The roots of a sparse system, found by ranges and counted by factorisations; in rad per unit of time.
class SparseSpectrum : public CountedSpectrum {
 public:
  /// @throws NotApplicable where K is singular and what is free cannot be told; TooLarge; NotConverged
  explicit SparseSpectrum(const SparseSystem& system, const Progress& progress = {});

  std::optional<RootRange> roots_before_counts(const Window& range, const Progress& progress) const override;
  RootRange roots(const Window& range, const Progress& progress = {}) const override;
  std::optional<RootRange> lowest_roots(Index count, const Window& range, const Progress& progress) const override;
  bool finite() const override { return false; }
  std::string why_an_end() const override { return "a large sparse model is searched window by window: "; }
  double above_all() const override { return infinity; }
  double outward() const override { return 64; }
  Index below(double omega) const override { return omega > 0 ? counts_.between(0, omega) : 0; }
  Index missed_by_signs(const Window& range) const override { return balance_.missed_by_signs(range); }
  Index zero_roots() const override { return balance_.index().zero; }
  Inertia inertia_at(double omega) const override { return counts_.at(omega); }
  Index negative_at_zero() const override { return counts_.at_zero(); }
  IndexBalance balance() const override { return balance_.index(); }
  std::string open_reason() const override { return balance_.open_reason(); }
  bool isolated() const override { return true; }
  void describe(ModesResult& result, bool with_shapes) const override;

 private:
  RootRange range_of(SparseModes modes, bool from_zero) const;
  /// A pair of zero roots, a drift or a displacement of null(K).
  Mode zero_mode(Index which, bool with_shape) const;
  bool rigid() const { return balance_.index().negative == 0 || searches_.free().rigid; }

  const SparseSystem& system_;
  Structure structure_;
  sparse::Searches searches_;
  SparseBalance balance_;
  mutable SparseCounts counts_;     // each factorisation is done when it is first asked for
  mutable SparseModes candidates_;  // of a window, not proved to be all
};

}  // namespace gyromode
