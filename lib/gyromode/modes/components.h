#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/certificate/verdict.h"
#include "gyromode/dense/solve.h"
#include "gyromode/spectrum/result.h"

#include <optional>
#include <vector>

namespace gyromode {

/// One component solved and judged.
struct SolvedComponent {
  Spectrum spectrum;
  dense::Impedance impedance;
  Assessment assessment;
  Verdict verdict;
};

/// A system solved component by component, before a window is cut out of it.
struct SolvedSystem {
  Structure structure;
  Index size = 0;
  bool first_order = false;
  std::vector<SolvedComponent> components;
  /// Work was stopped: further components were not solved, and the balance is open.
  bool interrupted = false;
  std::optional<InertiaOfK> whole;  ///< of K, where components are missing

  /// The worst component's; marginal, too, where roots of opposite energy sign of two components that K does not hold
  /// coincide: the least coupling may make them flutter.
  Stability stability() const;
  IndexBalance index_balance() const;
  std::string open_reason() const;  ///< why the balance of the first component that is not closed is open; empty where all are
  InertiaOfK stiffness() const;
  std::string solver() const;

  /// n₋(H(ω)) of the whole, ω > 0; doubtful where that of a component is.
  Inertia inertia_at(double omega) const;
  /// n₋(H(0⁺)) (theory (T10)).
  Index negative_at_zero() const;
};

/// All components; `progress` is told "components". Throws Interrupted where it stops before the first is solved.
SolvedSystem solve_components(const System& system, Method method, const Progress& progress = {});
SolvedSystem solve_components(const FirstOrderSystem& system, Method method, const Progress& progress = {});

}  // namespace gyromode
