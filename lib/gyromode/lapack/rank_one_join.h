#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// The join of divide and conquer (Cuppen 1981; Gu & Eisenstat, SIAM J. Matrix Anal. Appl. 16, 1995): diag(T₁, T₂) +
/// |ρ| z zᵀ with T_i = Q_i diag(d_i) Q_iᵀ and z = (last row of Q₁, ± first row of Q₂). The entries of T are of order
/// one.
///   d       the eigenvalues of both halves, each ascending; on return those of the whole, ascending
///   q       diag(Q₁, Q₂), n × n; on return the vectors
///   cut     order of T₁, 1 … n/2
///   rho     the coupling, with its sign
/// Deflation and the roots of the secular equation are LAPACK's (dlaed2, dlaed4); roots and vectors are shared out
/// among the threads of the BLAS, which dlaed3 does not do.
void join_rank_one(Vector& d, Matrix& q, Index cut, double rho);

}  // namespace gyromode::lapack
