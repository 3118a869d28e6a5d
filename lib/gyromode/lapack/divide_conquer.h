#pragma once

#include "gyromode/lapack/symmetric.h"

namespace gyromode::lapack {

/// All eigenvalues and vectors of the symmetric tridiagonal matrix with the given diagonal (n) and subdiagonal (n − 1), by divide and conquer (Cuppen 1981;
/// Gu & Eisenstat 1995). dstedc, but the first cut is made here, so that its two halves are solved at the same time (dstedc runs on one thread
/// but for its products), and joined by dlaed1.
SymmetricEigen tridiagonal_eigen(Vector diagonal, Vector subdiagonal);

}  // namespace gyromode::lapack
