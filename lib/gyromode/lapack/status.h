#pragma once

#include "gyromode/base/error.h"
#include "gyromode/base/types.h"

#include <string_view>

namespace gyromode::lapack {

/// `n` as LAPACK's integer. Throws TooLarge where n exceeds `limit`, the order at which the routine's own workspace
/// formula leaves 32 bits (2³¹ − 1 for routines that need O(n) only).
int dimension(Index n, std::string_view routine, Index limit = 2147483647);

/// Largest n with a·n² + b·n + c < 2³¹: what a routine with that workspace can take.
Index largest_order(double a, double b, double c);

/// Throws NotConverged for info < 0 (argument −info refused, or out of memory) and for info > 0, where `meaning` says
/// what LAPACK's manual says of it. Routines for which info > 0 is an answer (a failed Cholesky) test it before they
/// call this.
void require_success(int info, std::string_view routine, std::string_view meaning);

}  // namespace gyromode::lapack
