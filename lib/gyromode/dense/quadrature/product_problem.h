#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::dense {

/// The two halves of a quadrature motion with both stiffness blocks indefinite: Σ v̇ = −E_u u, Σᵀ u̇ = E_v v, u = (x, ẏ),
/// v = (ẋ, y) (theory (T6)). All m × m.
struct Product {
  Matrix sigma, sigma_inverse, eu, ev;
};

/// One root μ = ω² with its unit vector u, which is real (imaginary part zero) for real μ.
struct ProductRoot {
  Complex mu;
  ComplexVector u;
};

/// P = Σ⁻ᵀ E_v Σ⁻¹ E_u, ü = −P u.
Matrix product_matrix(const Product& p);

/// The problem in bases U and V of invariant subspaces of its two halves, orthonormal columns.
Product projected(const Product& p, const Matrix& u, const Matrix& v);

/// All roots, from the matrix P of the problem, which the caller may have cheaper than product_matrix(). Close roots
/// are separated on the self-adjoint pencil that P is in their span; roots far below the largest are projected out and
/// solved by themselves.
std::vector<ProductRoot> roots_of(const Product& p, const Matrix& product);

}  // namespace gyromode::dense
