#pragma once

#include "gyromode/base/types.h"
#include "gyromode/spectrum/inertia.h"

namespace gyromode {

/// Inertia by Bunch–Kaufman. The matrix is equilibrated by powers of two first (a congruence), so tiny diagonals and
/// mixed units do no harm. LAPACK's dsytrf and zhetrf: a factorisation without 2 × 2 pivots returns wrong counts. From
/// order 64 a matrix that may be definite by its diagonal is first tried by Cholesky.
Inertia inertia(const Matrix& symmetric);
Inertia inertia(const ComplexMatrix& hermitian);

/// The same of a matrix whose entries are sums of terms, scaled so that the largest term of every row is near 1: what
/// is small beside that is rounding of the terms.
Inertia inertia_of_sum(const Matrix& symmetric);
Inertia inertia_of_sum(const ComplexMatrix& hermitian);

/// Eigenvalues of the equilibrated matrix below −8 n ε of the largest: n₋ of a matrix that may be singular. Costs an
/// eigenvalue computation.
Index clearly_negative(const Matrix& symmetric);
Index clearly_negative(const ComplexMatrix& hermitian);

}  // namespace gyromode
