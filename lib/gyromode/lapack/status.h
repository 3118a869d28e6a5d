#pragma once

#include "gyromode/lapack/types.h"

#include <stdexcept>
#include <string_view>

namespace gyromode::lapack {

/// An iteration of LAPACK did not converge, or LAPACK refused an argument. Neither is the model's fault.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A matrix is too large for a dense method on this build (LAPACK indexes its workspace with 32 bits).
class TooLarge : public std::length_error {
 public:
  using std::length_error::length_error;
};

/// `n` as LAPACK's integer. Throws TooLarge where n exceeds `limit`, the order at which the routine's own workspace
/// formula leaves 32 bits (2³¹ − 1 for routines that need O(n) only).
int dimension(Index n, std::string_view routine, Index limit = 2147483647);

/// Largest n with a·n² + b·n + c < 2³¹: what a routine with that workspace can take.
Index largest_order(double a, double b, double c);

/// Throws Failure for info < 0 (argument −info refused, or out of memory) and for info > 0, where `meaning` says what LAPACK's
/// manual says of it. Routines for which info > 0 is an answer (a failed Cholesky) test it before they call this.
void require_success(int info, std::string_view routine, std::string_view meaning);

}  // namespace gyromode::lapack
