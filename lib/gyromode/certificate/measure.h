#pragma once

#include "gyromode/certificate/products.h"

#include <vector>

namespace gyromode {

/// What is measured of every root of a Spectrum on the matrices as they were given (changed to the natural units of the
/// component, which adds no rounding).
///
/// With r = H(ω)X the pair (ω, X) is exact for a Hermitian change of H whose entries, scaled as the optimal diagonal
/// scaling would, move a simple root by |X|ᵀ|r|/|form| to first order, whatever the units of the coordinates: the
/// optimum over D of ‖Dr‖‖D⁻¹X‖ is |X|ᵀ|r|. own_scale = Σ weight_i|X_i|². Forming r and the form itself, and the
/// coefficients where they are sums, adds some ε of rounded = Σ rounding_weight_i|X_i|².
struct Assessment {
  Vector residual;  ///< ‖H(ω)X‖₂ / ((‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖₂), 1-norms of matrices, everything in the units given
  Vector own_residual;  ///< ‖D r‖ / ‖D⁻¹X‖, D⁻² = diag(weight): the same in each coefficient's own scale
  Vector form;          ///< Xᴴ(2ωM − jG)X / ‖X‖²; first order XᴴIX / ‖X‖²: its sign is the energy sign.
                        ///< Of a SolvedComponent, in the units given: Xᴴ(2ωM − jG)X of its shapes as they stand
  /// |δω| ≤ (|X|ᵀ|r| + c ε rounded) / |Xᴴ(2ωM − jG)X|, c = 2 + √n, to first order, for a simple root. Where such
  /// intervals overlap the roots are a cluster of c, and the bound is that of their span: the same over the smallest
  /// singular value of [X_iᴴ(2ωM − jG)X_k], each X_i of own_scale 1.
  Vector error_bound;
  Vector sensitivity;          ///< |δω| for a backward error of 1 in each coefficient's own scale: own_scale / |form|
  std::vector<Index> cluster;  ///< c of every root, 1 for a simple one
  bool no_root_twice = false;  ///< Parseval's identity showed it (K regular, as many roots as there must be): see parseval.h

  /// The same of the roots off the axis, with the left vector Y: |δλ| ≤ (|Y|ᵀ|r| + c ε rounded) / |YᴴN′(λ)X|;
  /// own_residual is the larger one of X and Y.
  struct Unstable {
    Vector residual, own_residual, error_bound, sensitivity;
  } unstable;
};

/// Measures the roots of `s`, which are in ascending order, as they stand; nothing is changed. `p` and `of_unstable`
/// are the products of its shapes.
Assessment measure(const Impedance& h, const Spectrum& s, const Products& p, const CharacteristicProducts& of_unstable);
Assessment measure(const Impedance& h, const Spectrum& s);

}  // namespace gyromode
