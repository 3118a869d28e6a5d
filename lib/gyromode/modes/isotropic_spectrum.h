#pragma once

#include "gyromode/modes/sparse_spectrum.h"
#include "gyromode/sparse/isotropy.h"

namespace gyromode {

/// The roots of what is isotropic about the axis of the spin (sparse/isotropy.h), by those of it in axes that stand
/// still: of every s there the roots s + Ω and |s − Ω|, with energy of the sign of s − Ω for the second. They are all,
/// whatever the spin, and so are their counts: n₋(H(ω)) = N(ω + Ω) + N(|ω − Ω|), N(s) the number of roots below s.
class IsotropicSpectrum : public CountedSpectrum {
 public:
  IsotropicSpectrum(const SparseSystem& system, const sparse::Isotropy& isotropy, const Progress& progress);

  /// K₀ > 0, and Ω is no root to rounding: then what is said above holds.
  bool serves() const { return serves_; }

  RootRange roots(const Window& range, const Progress& progress = {}) const override;
  std::optional<RootRange> lowest_roots(Index count, const Window& range, const Progress& progress) const override;
  bool finite() const override { return false; }
  std::string why_an_end() const override { return still_.why_an_end(); }
  double above_all() const override { return infinity; }
  double outward() const override { return still_.outward(); }
  Index below(double omega) const override;
  Index missed_by_signs(const Window& range) const override;
  Index zero_roots() const override { return 0; }
  Inertia inertia_at(double omega) const override;
  Index negative_at_zero() const override { return 2 * negative_energy_; }
  IndexBalance balance() const override;
  std::string open_reason() const override { return ""; }
  bool isolated() const override { return true; }
  void describe(ModesResult& result, bool with_shapes) const override;

 private:
  SparseModes turned(const Window& range, const Progress& progress) const;
  Index number_below(double s) const { return s > 0 ? still_.inertia_at(s).negative : 0; }

  const SparseSystem& system_;
  const sparse::Isotropy& isotropy_;
  Structure structure_;
  sparse::Groups groups_;
  SparseSystem standing_;  // M₀, K₀
  SparseSpectrum still_;
  bool serves_ = false;
  Index negative_energy_ = 0;
};

}  // namespace gyromode
