#pragma once

#include "gyromode/sparse/searches.h"
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
  double outward() const override { return 64; }
  Index below(double omega) const override;
  Index missed_by_signs(const Window& range) const override;
  Index zero_roots() const override { return 0; }
  Inertia inertia_at(double omega) const override;
  Index negative_at_zero() const override { return searches_.stiffness().negative(); }
  IndexBalance balance() const override { return balance_; }
  std::string open_reason() const override;
  bool isolated() const override { return true; }
  void describe(ModesResult& result, bool with_shapes) const override;

 private:
  using Modes = std::vector<sparse::RitzMode>;
  void close_balance(const Progress& progress);
  /// As many modes of [a, b) as are counted there, `expected`, or those that were found.
  Modes between(double a, double b, Index expected, const Progress& progress, int depth = 3) const;
  Modes from_both_ends(double a, double b, Index expected, const Progress& progress) const;
  Modes about(double sigma, double a, double b, Index expected, const Progress& progress) const;
  Index expected_in(double a, double b) const;
  double gyroscopic_size() const;
  double margin_at(double omega) const;
  double middle_of(double a, double b) const;
  double gap_after(const Modes& roots, Index count) const;
  double clear_of_roots(double omega) const;
  /// A count below which those modes, the lowest, are all there are, of the modes at rest (theory T17): from it on
  /// down inertia_at() needs no factorisation. False where it does not close.
  bool close_at_rest(const Modes& lowest, Index wanted, const Progress& progress) const;
  RootRange range_of(Modes modes, double known_below = infinity) const;
  ComplexVector in_given(const ComplexVector& shape) const;
  Mode mode_of(const sparse::RitzMode& m, bool with_shape) const;

  const SparseSystem& system_;
  Structure structure_;
  sparse::Searches searches_;
  mutable std::map<double, Inertia> counted_;
  mutable std::map<double, double> margins_;
  mutable std::unique_ptr<sparse::Search> at_zero_;
  mutable double known_below_ = 0;  // all roots below that are in lowest_
  mutable std::vector<CountedRoot> lowest_;
  IndexBalance balance_;
  Modes negative_;
  std::vector<sparse::RitzUnstable> unstable_;
};

}  // namespace gyromode
