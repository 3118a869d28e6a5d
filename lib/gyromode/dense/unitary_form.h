#pragma once

#include "gyromode/system/system.h"

namespace gyromode::dense {

/// The n × n real form of any system, whatever its stiffness, by an n × n unitary matrix: the "unitary transformation
/// of the most general system" of Boland & Janssens 1979 (Conclusion), without a condition on K or on a partition
/// (theory (T8e); Paige & Van Loan, Linear Algebra Appl. 41, 1981; Van Loan, Linear Algebra Appl. 61, 1984).
///
/// In mass-normalised coordinates z with p = ż + ½Γz the system is Hamiltonian, d/dt (z, p) = 𝓗 (z, p), and an
/// orthogonal symplectic U = [Q₁ Q₂; −Q₂ Q₁], which is the unitary matrix Q₁ + jQ₂, takes −𝓗² to
///     −Uᵀ𝓗²U = [ W  R ; 0  Wᵀ ],   W real n × n, upper Hessenberg, with eigenvalues ω², each once:
/// ω² > 0 a mode, ω² < 0 divergence, a complex pair flutter. W cannot be symmetric in general, as its eigenvalues need
/// not be real. With v = displacement · q + velocity · q̇ every motion obeys v̈ = −Wᵀv.
struct UnitaryForm {
  Matrix w;                       ///< n × n, upper Hessenberg
  Matrix q1, q2;                  ///< n × n, Q₁ᵀQ₁ + Q₂ᵀQ₂ = 1, Q₁ᵀQ₂ symmetric
  Matrix displacement, velocity;  ///< n × n each
};

/// O(n³). Errors are ε‖𝓗‖² in W: an ω far below the largest has half its digits, as always where ω² is computed.
UnitaryForm unitary_form(const System& system);

}  // namespace gyromode::dense
