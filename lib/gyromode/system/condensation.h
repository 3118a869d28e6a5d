#pragma once

#include "gyromode/system/system.h"

#include <optional>
#include <vector>

namespace gyromode {

/// A system in which some coordinates s have no mass (their rows of M are zero): with G_ss = 0 and K_ss regular they
/// follow the others m without a motion of their own, s = −(F + λR) m, F = K_ss⁻¹K_sm, R = K_ss⁻¹G_sm, and
///     M' = M_mm + G_smᵀK_ss⁻¹G_sm,  G' = G_mm − G_msF − K_msR,  K' = K_mm − K_msF   (theory (T6a))
/// has exactly the finite roots of the whole.
struct Condensation {
  Labels labels;                         ///< of all coordinates, n
  std::vector<Index> massive, massless;  ///< positions among them, ascending
  System reduced;                        ///< M', G', K', with the labels of the massive ones
  std::vector<Repair> repairs;           ///< of the whole matrices, as given
  Matrix follow, follow_rate;            ///< F and R, massless × massive
  /// (K_ss + G_smM_mm⁻¹G_smᵀ)⁻¹: what N(λ)⁻¹ of the whole is between massless coordinates as λ → ∞
  Matrix compliance_at_infinity;
  /// What forming M', G', K' may have rounded, entry by entry: what rounding of K_ss⁻¹ and of the sums leaves.
  Matrix rounded_mass, rounded_gyroscopic, rounded_stiffness;

  /// All n entries of the shape of a root λ whose massive ones are x.
  ComplexVector expanded(Complex lambda, const ComplexVector& x) const;
};

/// The condensation of matrices as they are given; nothing where every row of M has an entry. Labels may be empty (q1
/// … qn). @throws LawBroken where G couples massless coordinates among themselves, where K_ss is singular (they would
/// be held by nothing), where no coordinate has mass, and as System does
std::optional<Condensation> condensation(const Matrix& mass, const Matrix& gyroscopic, const Matrix& stiffness, const Labels& labels,
                                         const Admission& admission);

}  // namespace gyromode
