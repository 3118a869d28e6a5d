#pragma once

#include "gyromode/dense/second_order.h"

namespace gyromode::dense {

/// The companion form of Willems et al. (reference 3 of Boland & Janssens 1979): all eigenvalues of the real 2n × 2n
/// matrix A = [−M⁻¹G −M⁻¹K; 1 0] for z = (q̇, q), by dgeev. Its eigenvalues carry rounding in their real parts; as in
/// `indefinite_modes` the Hamiltonian pairing decides which of them are undamped.
void solve_companion(const SecondOrder& m, Spectrum& s);

/// Meirovitch 1974 (reference 4): with z = (q̇, q), M* = diag(M, K) and G* = [G K; −K 0], the real symmetric pencil K* =
/// G*ᵀM*⁻¹G* against M* of order 2n has every ω² twice. Throws NotApplicable unless K > 0.
void solve_symmetric_2n(const SecondOrder& m, Spectrum& s);

}  // namespace gyromode::dense
