#pragma once

#include "gyromode/sparse/search.h"
#include "gyromode/spectrum/counted_spectrum.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gyromode {

/// The roots of a sparse system, found by ranges and counted by factorisations; in rad per unit of time. Modes of
/// negative energy and growing motions are looked for at once, near ω = 0, until the index balance closes.
class SparseSpectrum : public CountedSpectrum {
 public:
  /// @throws NotApplicable where K is singular to rounding; TooLarge; NotConverged
  explicit SparseSpectrum(const SparseSystem& system, const Progress& progress = {});

  RootRange roots(const Window& range, const Progress& progress = {}) const override;
  std::optional<RootRange> lowest_roots(Index count, const Window& range, const Progress& progress) const override;
  bool finite() const override { return false; }
  std::string why_an_end() const override { return "a large sparse model is searched window by window: "; }
  double above_all() const override { return infinity; }
  Index below(double omega) const override;
  Index missed_by_signs(const Window& range) const override;
  Index zero_roots() const override { return 0; }
  Inertia inertia_at(double omega) const override;
  Index negative_at_zero() const override { return stiffness_negative_; }
  IndexBalance balance() const override { return balance_; }
  std::string open_reason() const override;
  bool isolated() const override { return true; }
  void describe(ModesResult& result, bool with_shapes) const override;

 private:
  using Modes = std::vector<sparse::RitzMode>;
  void close_balance(const Progress& progress);
  Modes between(double a, double b, Index expected, const Progress& progress) const;
  Index expected_in(double a, double b) const;
  RootRange range_of(Modes modes) const;
  Mode mode_of(const sparse::RitzMode& m, bool with_shape) const;

  const SparseSystem& system_;
  Structure structure_;
  sparse::Norms norms_;
  mutable sparse::ShiftedImpedance impedance_;
  mutable std::map<double, Inertia> counted_;
  mutable std::unique_ptr<sparse::Search> at_zero_;
  Index stiffness_negative_ = 0;
  IndexBalance balance_;
  Modes negative_;
  std::vector<sparse::RitzUnstable> unstable_;
};

}  // namespace gyromode
