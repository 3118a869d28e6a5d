#pragma once

#include "gyromode/certificate/products.h"

namespace gyromode {

/// Whether Parseval's identity shows that no root is listed twice, K regular and as many roots as the order asks for
/// given (m modes, d real pairs, f quadruples with m + d + 2f = n).
///
/// z = (X, λX) of two roots are orthogonal in the energy product ⟨u, v⟩ = uᴴ diag(K, M) v unless one is −λ̄ of the
/// other, so that for every real v the energies of its parts add up to ⟨v, v⟩:
///     2|⟨z_i, v⟩|²/⟨z_i, z_i⟩ of a mode,   4 Re (or 2, λ real) of ⟨z_λ, v⟩ conj(⟨z_−λ̄, v⟩/⟨z_−λ̄, z_λ⟩) of a quadruple (a real pair).
/// A root listed twice in the place of another breaks that for nearly every v. Two random v are tried, of displacements
/// and of velocities: true where every root has, in one of them, a share a thousand times what is missing or too much.
/// O(n²), and it says nothing where rounding leaves a share in doubt.
bool no_root_twice(const Impedance& h, const Spectrum& s, const Products& p);

}  // namespace gyromode
