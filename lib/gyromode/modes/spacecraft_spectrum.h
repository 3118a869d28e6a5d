#pragma once

#include "gyromode/roots/certified_roots.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"
#include "gyromode/spectrum/counted_spectrum.h"

namespace gyromode {

/// Fields of wires are marched in some ω/Ω steps, and followed no farther than this.
constexpr double farthest_over_spin = 1e7;

/// The roots of a spacecraft with exact booms, isolated by counts, range by range. Frequencies are over the spin. Spin
/// phase and axial translation (ω = 0) and the tilt of the momentum axis (ω = Ω) are rigid-body roots.
class SpacecraftSpectrum : public CountedSpectrum {
 public:
  explicit SpacecraftSpectrum(const Spacecraft& s);
  SpacecraftSpectrum(const SpacecraftSpectrum&) = delete;  // its roots refer to its impedance
  SpacecraftSpectrum& operator=(const SpacecraftSpectrum&) = delete;

  const CertifiedRoots& certified() const { return roots_; }
  const SpacecraftImpedance& impedance() const { return impedance_; }
  const Spacecraft& spacecraft() const { return spacecraft_; }

  double unit() const override { return impedance_.unit_frequency(); }
  RootRange roots(const Window& range, const Progress& progress = {}) const override;
  bool finite() const override { return !impedance_.continuous(); }
  /// There J has counted each coordinate. Throws InvalidArgument where numbers do not reach so far.
  double above_all() const override;
  double reach() const override { return spacecraft_.cables().empty() ? infinity : farthest_over_spin; }
  std::string reach_reason() const override;
  Index most_roots() const override { return 20000; }  // the time goes with their square: minutes
  Index below(double omega) const override { return roots_.below(omega); }
  Index missed_by_signs(const Window& range) const override;
  /// Pairs of zero roots: spin phase, axial translation, neutral patterns of wires on the axis.
  Index zero_roots() const override;
  Inertia inertia_at(double omega) const override { return roots_.inertia_at(omega); }
  Index negative_at_zero() const override;
  IndexBalance balance() const override;
  std::string open_reason() const override;
  bool isolated() const override { return true; }
  void describe(ModesResult& result, bool with_shapes) const override;

 private:
  double gap_of_opposite_signs() const;
  Stability stability() const;
  std::string solver() const;

  Spacecraft spacecraft_;
  SpacecraftImpedance impedance_;
  CertifiedRoots roots_;
  double opposite_gap_;
};

/// Which of (ζ, θ) meet, and which of them move in phase.
Structure structure_of(const BlockedImpedance& h);

}  // namespace gyromode
