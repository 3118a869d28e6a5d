#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// An orthogonal reflection R = V₊V₊ᵀ − V₋V₋ᵀ beside a symmetric k and a skew Γ (n × n), seen in its own basis:
///     k = [k₁ k₁₂; k₁₂ᵀ k₂],   Γ = [Γ₁ b; −bᵀ Γ₂];   kR = Rk and ΓR = −RΓ  ⇔  k₁₂ = 0, Γ₁ = 0, Γ₂ = 0.
struct Reflection {
  Matrix plus, minus;  ///< V₊ n × p, V₋ n × r, orthonormal
  Matrix k1, k2, b;
  Matrix k12, gamma1, gamma2;

  Reflection(const Matrix& k, const Matrix& gamma, Matrix plus, Matrix minus);
  double departure_k() const;      ///< ‖kR − Rk‖_F / 2 = √2 ‖k₁₂‖_F
  double departure_gamma() const;  ///< ‖ΓR + RΓ‖_F / 2
};

/// sign(X) of a symmetric X, and how clear the signs are: smallest over largest |eigenvalue|.
struct SignedBasis {
  Matrix plus, minus;
  double clearness = 0;
};
SignedBasis sign_of(const Matrix& x);

/// The reflection that commutes with k and is nearest to R: in the eigenvectors of k, entries of R between eigenvalues
/// that differ by more than `noise` are left out, and the sign is taken. What k fixes to rounding it fixes exactly,
/// however small its differences are beside ‖k‖; what is left to Γ is little to turn.
SignedBasis commuting_with(const Matrix& k, const Reflection& r, double noise);

/// R turned to make departure_k²/unit_k² + departure_gamma²/unit_gamma² least: V₊ − V₋θᵀ, V₋ + V₊θ with θ from the
/// linearised conditions
///     k₁₂ + k₁θ − θk₂ = 0,   Γ₁ + θbᵀ − bθᵀ = 0,   Γ₂ − bᵀθ + θᵀb = 0
/// in the sense of least squares, by conjugate gradients; a few turns at most, only such as help, and none once the
/// root of that sum is `enough`.
Reflection turned(const Matrix& k, const Matrix& gamma, Reflection r, double unit_k, double unit_gamma, double enough);

}  // namespace gyromode
