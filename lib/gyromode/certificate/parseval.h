#pragma once

#include "gyromode/certificate/products.h"

namespace gyromode {

/// Whether Parseval's identity shows that no mode is listed twice, K > 0 and as many modes as coordinates given.
///
/// z = (X, jωX) and z̄ of all modes are orthogonal in the energy product ⟨u, v⟩ = uᴴ diag(K, M) v, so that for every real v the energies 2|⟨z_i, v⟩|²/⟨z_i, z_i⟩ add up to ⟨v, v⟩. A mode listed
/// twice and one left out would break that for nearly every v. Two random v are tried, of displacements and of velocities: true where every mode has, in one of them, a share a thousand times
/// what is missing or too much. O(n²), and it says nothing where rounding leaves a share in doubt.
bool no_mode_twice(const Impedance& h, const dense::Spectrum& s, const Products& p);

}  // namespace gyromode
