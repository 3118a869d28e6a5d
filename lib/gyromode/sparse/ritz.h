#pragma once

#include "gyromode/sparse/subspace.h"
#include "gyromode/spectrum/spectrum.h"
#include "gyromode/spectrum/window.h"

#include <vector>

namespace gyromode::sparse {

/// A root of the whole system as a subspace knows it.
struct RitzMode {
  double omega = 0;        ///< ω > 0
  int energy_sign = 1;     ///< of Xᴴ(2ωM − jG)X
  double form = 0;         ///< Xᴴ(2ωM − jG)X
  double residual = 0;     ///< ‖H(ω)X‖₂ / ((‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖₂), 1-norms
  double error_bound = 0;  ///< on |δω|, to second order in the residual; with what rounding of the matrices does
  ComplexVector shape;     ///< X
};

/// A growing motion as a subspace knows it.
struct RitzUnstable {
  Complex lambda;
  double residual = 0;     ///< ‖N(λ)X‖₂ / ((‖K‖ + |λ|‖G‖ + |λ|²‖M‖)‖X‖₂)
  double error_bound = 0;  ///< on |δλ|, to first order
  ComplexVector shape;
};

/// What the projected system says of a subspace: its roots, ascending, and growing motions.
struct RitzPairs {
  Vector omega;                ///< undamped roots, ascending
  ComplexMatrix coefficients;  ///< of their shapes in V
  UnstableRoots unstable;      ///< shapes by coefficients in V
};
RitzPairs ritz_pairs(const Subspace& v);

/// The norms of a system, in the coordinates given.
struct Norms {
  double k = 0, g = 0, m = 0;
};
Norms norms_of(const SparseSystem& system);

/// Roots and growing motions, measured on the matrices.
struct MeasuredRoots {
  std::vector<RitzMode> modes;         ///< of a range, ascending
  std::vector<RitzUnstable> unstable;  ///< all that the subspace holds, where the range begins at 0
  bool stopped = false;                ///< the user stopped the search: what has converged from the beginning of the range on
};
MeasuredRoots measured_in(const SparseSystem& system, const Norms& norms, const Subspace& v, const Window& range);

/// A bound on |δω| of a root ω of `all` that is within ρ of a true one to first order.
double error_of(double rho, double omega, const Vector& all);

/// Residual, form and error of the roots `chosen`.
std::vector<RitzMode> measured(const SparseSystem& system, const Norms& norms, const Subspace& v, const RitzPairs& pairs,
                               const std::vector<Index>& chosen);

}  // namespace gyromode::sparse
