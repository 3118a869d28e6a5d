#pragma once

#include "gyromode/base/types.h"

#include <algorithm>
#include <limits>

namespace gyromode {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();  ///< 2⁻⁵²
inline constexpr double infinity = std::numeric_limits<double>::infinity();

/// n ε, n at least 2: the unit in which rounding of matrices of order n is measured.
inline double rounding_unit(Index n) { return static_cast<double>(std::max<Index>(n, 2)) * epsilon; }

/// 4 n ε: a backward error of this size, relative to each coefficient in its own scale (Impedance::weight), is within
/// what reading and solving the model may have done.
inline double backward_error(Index n) { return 4 * rounding_unit(n); }

/// 8 n ε: an eigenvalue, singular value or pivot not above this part of the largest, or of its own terms, is zero.
inline double zero_to_rounding(Index n) { return 8 * static_cast<double>(n) * epsilon; }

/// 30 n ε: residuals up to here are what a backward stable solver leaves; beyond it something was lost.
inline double solver_residual(Index n) { return 30 * rounding_unit(n); }

}  // namespace gyromode
