#pragma once

#include "gyromode/system/system.h"
#include "gyromode/system/units.h"

#include <optional>

namespace gyromode {

/// A reversing symmetry of M q̈ + G q̇ + K q = 0: a real R with
///     R² = 1,   RᵀMR = M,   RᵀKR = K,   RᵀGR = −G                                  (theory (T7)),
/// such as a mirror through the spin axis combined with time reversal. Its eigenspaces for +1 and −1 are the two groups
/// of a quadrature partition, in whatever coordinates the matrices are written (Boland & Janssens 1979, Eq. 8, asks for
/// coordinates that show it).
struct ReversingSymmetry {
  /// q = in_phase · x + in_quadrature · y, n × p and n × r, p + r = n; mass-normalised: [in_phase in_quadrature]ᵀ M
  /// [in_phase in_quadrature] = 1.
  Matrix in_phase, in_quadrature;
  /// ẍ + b ẏ + k₁x = 0, ÿ − bᵀẋ + k₂y = 0: coupling b (p × r), stiffness1 (p × p), stiffness2 (r × r).
  Matrix coupling, stiffness1, stiffness2;

  /// R = 2·in_phase·in_phaseᵀM − 1, n × n, in the coordinates of q.
  Matrix reflection(const Matrix& mass) const;
  /// The same in other units of the coordinates and of time.
  ReversingSymmetry in_units(const Units& units) const;
};

/// The outcome of a search. In mass-normalised coordinates k, Γ, with R orthogonal, the departure of (T7) is max(‖kR −
/// Rk‖/2‖k‖, ‖ΓR + RΓ‖/2‖Γ‖), Frobenius norms.
struct SymmetrySearch {
  std::optional<ReversingSymmetry> found;
  /// of the R found, or of the nearest miss; where an invariant excluded R, |tr(Γ kΓ k²Γ)| n^1.5 over the norms
  double departure = 0;
  double threshold = 0;  ///< what rounding in the given matrices can do: c·n·ε·amplification, to compare with `departure`
  /// of relative rounding in M, G, K by the change to mass-normalised coordinates: between 1 and about the condition of
  /// M
  double amplification = 1;
};

/// Seeks R by the Hermitian matrix A = k/‖k‖ + jαΓ/‖Γ‖: RAR = Ā, so R takes its eigenvectors u to eigenvectors ū of Ā.
/// With A = U diag(μ) Uᴴ, R = Ū D Uᴴ, D block-diagonal over repeated μ, and R real (Conjugation). What is found is
/// verified on k and Γ. Matrices n × n, of one connected component; cost: a complex eigenproblem of order n and some
/// products.
///
/// `quick`: an invariant is asked first. R turns tr(Γ kΓ k²Γ), odd in Γ, into its negative, so where that is not zero
/// by far there is no R, and what was found is its size instead of a departure: a tenth of the cost.
SymmetrySearch find_reversing_symmetry(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness, bool quick = false);

}  // namespace gyromode
