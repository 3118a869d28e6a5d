#pragma once

#include "gyromode/system/system.h"

#include <cstdint>

namespace gyromode::bench {

/// Seeded systems of order n. Symmetric positive definite matrices are Q diag(logspace) Qᵀ, Q random orthogonal, of
/// condition 1e3 where nothing else is said.

/// Quadrature class, K > 0 of the given condition: M = diag(M₁, M₂), K = diag(K₁, K₂), G = [0 B; −Bᵀ 0], p = r = n/2, B
/// Gaussian, scaled so that gyroscopic and elastic terms are comparable: ‖Γ‖² = ‖k‖ (2-norms) in mass-normalised
/// coordinates, where at ω² = ‖k‖ the three terms of H(ω) are of one size.
System quadrature_definite(Index n, double condition, std::uint64_t seed);

/// No partition, K > 0: M, K > 0 full, G Gaussian and skew, scaled in the same way.
System general_definite(Index n, std::uint64_t seed);

/// What the pairs of quadrature_indefinite may be.
enum class Balance {
  stabilised,  ///< no growing motion: a pair with k₁, k₂ < 0 has b > √|k₁| + √|k₂|
  mixed        ///< also divergence (k₁k₂ < 0) and flutter (b below that limit)
};

/// Quadrature class, both stiffness blocks indefinite: n/2 pairs ẍ + bẏ + k₁x = 0, ÿ − bẋ + k₂y = 0 mixed by random
/// congruences S₁, S₂ of condition √1000, M_i = S_iᵀS_i, K_i = S_iᵀ diag(k_i) S_i, B = S₁ᵀ diag(b) S₂: dense, and of
/// known roots.
System quadrature_indefinite(Index n, Balance balance, std::uint64_t seed);

/// What makes an indefinite system without a partition hard.
enum class Regime {
  plain,
  spin20,  ///< G twenty times as large
  huge,    ///< G 10⁶ times as large
  graded,  ///< K over eight decades
  mixed,   ///< every coordinate in a unit of its own, 2⁻²⁰ … 2²⁰
  /// no random system: a chain of n/2 masses, clamped at one end, bending in two directions in axes that turn ten times
  /// as fast as its slowest mode, in orthogonal coordinates that hide it
  beam,
  copies  ///< two copies of one system of order n/2, in orthogonal coordinates that hide it
};

/// M = 1, K with |eigenvalues| in [½, 2] and a tenth of them negative, in random orthogonal coordinates, G Gaussian and
/// skew with entries of variance 1/n: no partition, divergence and flutter.
System general_indefinite(Index n, Regime regime, std::uint64_t seed);

/// A symmetric matrix of order n with Gaussian entries.
Matrix random_symmetric(Index n, std::uint64_t seed);

}  // namespace gyromode::bench
