#pragma once

#include "gyromode/base/error.h"
#include "gyromode/spectrum/unstable_roots.h"
#include "gyromode/spectrum/method.h"
#include "gyromode/base/types.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/system/units.h"

#include <string>
#include <vector>

namespace gyromode {

/// All roots of one connected component of M q̈ + G q̇ + K q = 0 (or I q̇ + G q = 0), as a solver leaves them: not yet
/// certified.
struct Spectrum {
  /// Positions of the component's coordinates in the system; with a partition those in phase come first.
  std::vector<Index> order;
  Index split = -1;  ///< number of coordinates in phase, −1 without a partition

  Vector omega;  ///< undamped roots with ω > 0, ascending
  /// Shapes X = re + j im in the order above. With a partition re holds the first `split` rows only and im the others
  /// only.
  Matrix re, im;

  Matrix zero_shapes;  ///< n × zero_pairs, real: one column a pair of zero roots (a zero root, in first order)
  UnstableRoots unstable;

  Index stiffness_negative = 0;  ///< n₋(K)
  Index stiffness_zero = 0;      ///< dim null(K)
  double stiffness_margin = 1;   ///< smallest over largest |eigenvalue| of the equilibrated K
  bool rank_doubtful = false;    ///< a rank decision on K that another program could take otherwise
  Index reduced_negative = 0;    ///< n₋(K) without ignorable coordinates: k_r + 2k_c + 2k₋ (theory (T12))
  Index impedance_negative = 0;  ///< n₋(H(0⁺)) (theory (T10))

  std::string solver;  ///< which solver, and why

  Index size() const { return static_cast<Index>(order.size()); }
  Index zero_pairs() const { return zero_shapes.cols(); }
  /// The number of real pairs and of quadruples among the unstable roots.
  Index divergent() const;
  Index fluttering() const;
  /// The same roots and shapes, found in the units `from`, in the units given.
  void to_given_units(const Units& from);
  /// The counts of a regular K; a singular one corrects the reduced ones later.
  void store_stiffness(const StiffnessInertia& d);
  /// Column k as a complex vector of all rows, in the order above.
  ComplexVector shape(Index k) const;
};

}  // namespace gyromode
