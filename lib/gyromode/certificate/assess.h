#pragma once

#include "gyromode/dense/impedance.h"

#include <vector>

namespace gyromode {

/// 4 n ε (n at least 2): a backward error of this size, relative to ‖K‖ + ω‖G‖ + ω²‖M‖, is within what reading and solving the model may have done.
double backward_error(Index n);

/// What is measured of every root of a Spectrum on the matrices as they were given.
struct Assessment {
  Vector residual;      ///< ‖H(ω)X‖₂ / ((‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖₂), 1-norms of matrices
  Vector form;          ///< Xᴴ(2ωM − jG)X / ‖X‖²; first order XᴴIX / ‖X‖²: its sign is the energy sign
  /// |δω| ≤ (‖H(ω)X‖ + ε·scale·‖X‖)‖X‖ / |Xᴴ(2ωM − jG)X|, to first order, for a simple root. Where such intervals overlap the roots are a cluster of c, and the bound is
    /// that of their span: ‖[H(ω_i)X_i]‖ / σ_min([X_iᴴ(2ωM − jG)X_k]) over unit X_i, √c times as large where the X_i are as good as orthogonal.
  Vector error_bound;
  Vector sensitivity;   ///< |δω| for a backward error of 1 in H relative to scale: scale·‖X‖² / |Xᴴ(2ωM − jG)X|
  std::vector<Index> cluster;  ///< c of every root, 1 for a simple one
};

/// Moves every ω of `s` to the root of Xᴴ H(ω) X = 0 near it (the Rayleigh functional, whose error is quadratic in that of X) by Newton's method, where that
/// is a correction and no jump; then measures. `s` stays sorted.
Assessment assess(const Impedance& h, dense::Spectrum& s);

/// Measures `s` as it stands, sorting it.
Assessment measure(const Impedance& h, dense::Spectrum& s);

}  // namespace gyromode
