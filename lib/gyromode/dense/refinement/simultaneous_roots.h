#pragma once

#include "gyromode/dense/impedance.h"

#include <optional>

namespace gyromode::dense {

/// All μ = λ² ≠ 0 with det N(λ) = 0, N(λ) = K + λG + λ²M, `pairs` of them, second order, by simultaneous iteration
/// (Ehrlich 1967, Aberth 1973; for matrix polynomials Bini & Noferini, Linear Algebra Appl. 439, 2013): each
/// approximation moves by Newton's step for the determinant divided by the factors of all others, 1/(q′/q − Σ 1/(μ_i −
/// μ_k)), q(μ) = det N/μ^(n − pairs). N is evaluated, equilibrated and factored at each root, so every root is found in
/// its own scale, however far apart they are, and no two approximations end at one simple root. Conjugate pairs are
/// exact, and a root nearer to its own conjugate than to any other's is real. Some ten factorisations of order n a
/// root. Nothing where counts or iterations do not settle.
std::optional<ComplexVector> simultaneous_roots(const Impedance& h, Index pairs);

}  // namespace gyromode::dense
