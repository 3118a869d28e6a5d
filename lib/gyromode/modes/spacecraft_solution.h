#pragma once

#include "gyromode/impedance/certified_roots.h"
#include "gyromode/modes/result.h"
#include "gyromode/spacecraft/spacecraft_impedance.h"

namespace gyromode {

/// A spacecraft solved as far as windows can be cut from it: everything that does not depend on one. Frequencies are over the spin.
class SpacecraftSolution {
 public:
  explicit SpacecraftSolution(const Spacecraft& s);
  SpacecraftSolution(const SpacecraftSolution&) = delete;  // its roots refer to its impedance
  SpacecraftSolution& operator=(const SpacecraftSolution&) = delete;

  const CertifiedRoots& roots() const { return roots_; }
  const SpacecraftImpedance& impedance() const { return impedance_; }
  const Spacecraft& spacecraft() const { return spacecraft_; }
  double unit() const { return impedance_.unit_frequency(); }

  /// Pairs of zero roots: spin phase, axial translation, neutral patterns of wires on the axis.
  Index zeros() const;
  IndexBalance balance() const;
  Stability stability() const;
  /// Smallest relative distance of a mode of negative energy to one of positive energy in its block; infinite where there is none.
  double opposite_gap() const { return opposite_gap_; }
  std::string path() const;
  /// A frequency above every mode of a body without booms: there J has counted each coordinate. Throws std::invalid_argument where there is none.
  double above_all() const;

  /// Roots in a little more than [a, b), so that what stands on an end is seen; the tilt of the momentum axis among them named (is_tilt) and exactly at Ω.
  std::vector<Root> roots_around(double a, double b) const;
  static bool is_tilt(const Root& r) { return r.rigid; }
  /// The window with each end that is on a root to rounding moved outward, as far as it takes for the count there to be beyond doubt. It depends on the ends alone.
  Window cleared(Window w) const;

 private:
  void name_tilt(std::vector<Root>& all) const;
  double gap_of_opposite_signs() const;

  Spacecraft spacecraft_;
  SpacecraftImpedance impedance_;
  CertifiedRoots roots_;
  double opposite_gap_;
};

/// Where a root may be: its error bound, and not less than what rounding of ω itself leaves open.
double open_error(const Root& r);

/// Which of (ζ, θ) meet, and which of them move in phase.
Structure structure_of(const BlockedImpedance& h);

}  // namespace gyromode
