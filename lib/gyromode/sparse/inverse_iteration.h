#pragma once

#include "gyromode/base/rounding.h"
#include "gyromode/sparse/matrix.h"

#include <functional>

namespace gyromode::sparse {

/// Below that a form is rounding, and the signs of pivots are worth nothing (theory sparse §1).
constexpr double singular_margin = 1e3 * epsilon;

/// The least |xᵀAx| over |x|ᵀ|A||x| that three steps of inverse iteration find, A and M by lower triangles: how far A
/// is from singular. `solve` is A⁻¹.
double least_form(const std::function<Matrix(Matrix)>& solve, const SparseMatrix& a, const SparseMatrix& mass);

}  // namespace gyromode::sparse
