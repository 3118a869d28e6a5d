#pragma once

#include "gyromode/lapack/symmetric.h"

namespace gyromode::lapack {

/// All eigenvalues and vectors of the symmetric tridiagonal matrix with the given diagonal (n) and subdiagonal (n − 1),
/// by divide and conquer. LAPACK's dstedc runs on one thread but for its products: with more, the first cut is made
/// here, its halves are solved by dstedc at the same time and joined by join_rank_one.
SymmetricEigen tridiagonal_eigen(Vector diagonal, Vector subdiagonal);

}  // namespace gyromode::lapack
