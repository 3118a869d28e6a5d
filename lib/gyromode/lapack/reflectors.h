#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// Q = H₀H₁…, H_k = 1 − τ_k v_k v_kᵀ, of a reduction of an n × n matrix to tridiagonal or bidiagonal form. Column k of
/// `vectors` holds v_k below row k + first, where v_k is 1; v_k is zero above and what `vectors` holds there is not
/// read (dsytrd's storage of the lower triangle, dgebrd's of Q).
struct Reflectors {
  Matrix vectors;  ///< n × n
  Vector tau;      ///< n − first
  Index first = 1;

  Index size() const { return vectors.rows(); }
};

/// x := x Q, x m × n; in panels 1 − V T Vᵀ (Schreiber & Van Loan, SIAM J. Sci. Stat. Comput. 10, 1989).
void multiply_right(MatrixSpan x, const Reflectors& q);
/// x := Q x, x n × m.
void multiply_left(const Reflectors& q, MatrixSpan x);

}  // namespace gyromode::lapack
