#pragma once

#include "campaign/hostile_system.h"

#include "gyromode/spectrum/result.h"
#include "reference/high_precision.h"

#include <string>
#include <vector>

namespace gyromode::support {

/// What is true of a hostile system: the roots of its components by the 100-digit twin, in the unit of time of `given`.
struct Truth {
  struct Root {
    double omega;
    int sign;  ///< 0 at a defective root
  };
  Index zero_pairs = 0;
  std::vector<Root> modes;                         ///< ω > 0, ascending
  std::vector<double> divergence;                  ///< ascending
  std::vector<std::pair<double, double>> flutter;  ///< (σ, ω), ascending
  Stability stability = Stability::stable;
  double distance = 1;  ///< of the verdict from another one, see reference::Spectrum
};
Truth truth_of(const HostileSystem& h);

/// The verdict of the 100-digit twin in our words.
Stability stability_of(reference::Spectrum::Verdict v);

/// How an answer compares with the truth. Everything but `refused` is a false claim.
struct Faults {
  bool false_complete = false, false_verdict = false, wrong_sign = false, mode_outside_bound = false, growth_outside_bound = false,
       window_moved = false, false_count = false;
  bool refused = false;  ///< exit 4: not complete, or verdict unknown
  bool evaded = false;   ///< `marginal` where the truth is decided, farther than 1e-7 from another verdict
  std::string text;

  bool claims_falsely() const {
    return false_complete || false_verdict || wrong_sign || mode_outside_bound || growth_outside_bound || window_moved || false_count;
  }
};
/// `tightness` collects error bound over true error of every mode, where the error is not zero.
Faults compare(const System& system, const ModesResult& r, const Truth& truth, std::vector<double>* tightness = nullptr);

}  // namespace gyromode::support
