#pragma once

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/base/rounding.h"
#include "gyromode/system/system.h"

#include <string_view>

namespace gyromode {

/// The largest order of a dense model. Eigenvalue problems of order 2n are indexed by LAPACK with 32 bits, 8n² + 12n +
/// 1 < 2³¹, and at this order a solver takes some 40 n² bytes, 11 GB, beside the model's own 24 n².
inline constexpr Index most_coordinates = 16'383;

/// Throws TooLarge for n beyond it; `what` is of that order, "a model".
void require_order(std::string_view what, Index n);

/// Throw LawBroken unless the matrix `name` keeps the law. Entries count from 1 in messages, as in Matrix Market.
void require_square(std::string_view name, const Matrix& a);
void require_finite(std::string_view name, const Matrix& a);
/// A positive definite: scaled to unit diagonal, its smallest eigenvalue above n ε.
void require_positive_definite(std::string_view name, const Matrix& a, const Labels& labels);

}  // namespace gyromode
