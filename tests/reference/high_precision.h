#pragma once

// The slow, obvious twin of the gyroscopic eigenvalue solvers, in 100 decimal digits:
//
//     M q'' + G q' + K q = 0,   M = Mᵀ > 0,  G = −Gᵀ,  K = Kᵀ,   q = X e^{λt},   H(ω) = K − ω²M + jωG   (λ = jω)
//
// The doubles of M, G, K are taken as exact. Structure (what is zero, multiple, defective, on the axis) is decided in
// high precision; only the numbers returned are rounded to double. Meant for n ≤ 12. Shares no code with lib/.
//
// How far apart "equal" and "different" are, everything relative:
//
//   1e-100   the working precision u. A Jordan block of size m splits by u^{1/m}: 1e-50, 1e-33, 1e-25, 1e-20 for m = 2..5.
//   1e-50    below this a stiffness or a pivot is zero. Zero roots are not clustered: they are removed by repeated null spaces
//            (a staircase), which counts them algebraically and does not split a defective root 0, whatever its multiplicity.
//   1e-30    a null vector of H, or a vanishing energy, at a multiple root. Simple roots need no threshold.
//   1e-18    roots λ² nearer than this are one cluster. Doubles perturb by 1e-16, so two roots that were meant to coincide and
//            do not, by rounding of the entries, are two roots here, and `distance` says how near.

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace gyromode::reference {

struct Spectrum {
  /// stable: K ≥ 0. gyroscopically_stabilised: n₋(K) > 0, every root on the axis, non-zero and semisimple, no
  /// coinciding roots of opposite sign. unstable: some root has Re λ > 0 (divergence or flutter). It takes precedence
  /// over marginal. marginal: n₋(K) > 0, no root off the axis, but a root 0, a defective root or coinciding roots of
  /// opposite sign.
  enum class Verdict { stable, gyroscopically_stabilised, marginal, unstable };

  int zero_roots = 0;                              ///< algebraic multiplicity of λ = 0 (of the 2n roots)
  std::vector<double> omega;                       ///< λ = ±jω, ω > 0 ascending, with algebraic multiplicity
  std::vector<int> energy_sign;                    ///< sign of Xᴴ(2ωM − jG)X; at equal ω: + first, then −, then 0 where defective
  std::vector<double> divergence;                  ///< λ = ±σ, σ > 0 ascending
  std::vector<std::pair<double, double>> flutter;  ///< λ = ±σ ± jω, (σ > 0, ω > 0), ascending in σ
  int negative_stiffness = 0;                      ///< n₋(K)
  int zero_stiffness = 0;                          ///< dim null K
  Verdict verdict = Verdict::stable;

  /// How near the verdict is to changing: 0 when marginal, else the least of
  ///   (a) the gap between neighbouring roots jω of opposite sign / max|λ|  (0 at a defective root),
  ///   (b) Re λ of each unstable root / max|λ|,
  ///   (c) min|κ| / max|κ| over the non-zero eigenvalues κ of K  (1 if K = 0).
  /// K ≥ 0 leaves (c) alone. These are distances of roots: a defective double root opens by the square root of a
  /// perturbation, so (a) or (b) = 1e-8 is a change of 1e-16 in the matrices.
  double distance = 1;
};

/// All roots. Throws InvalidArgument unless M, G, K are square, of one size, finite, and exactly M = Mᵀ > 0, G = −Gᵀ,
/// K = Kᵀ; std::logic_error if the roots found contradict the inertia counts of H (a fault of the twin).
Spectrum spectrum(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K);

/// n₋(K − ω²M + jωG) for real ω. An eigenvalue of H within 1e-50 (‖K‖ + ω²‖M‖ + |ω|‖G‖) of zero is not counted. Same
/// promises on M, G, K, but M may be indefinite.
int negative_eigenvalues_of_impedance(const Eigen::MatrixXd& M, const Eigen::MatrixXd& G, const Eigen::MatrixXd& K, double omega);

}  // namespace gyromode::reference
