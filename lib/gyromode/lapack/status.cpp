#include "gyromode/lapack/status.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>
#include "gyromode/lapack/lapacke_complex.h"

#include <cmath>
#include <new>

namespace gyromode::lapack {

int dimension(Index n, std::string_view routine, Index limit) {
  if (n > limit) {
    throw TooLarge(fmt::format("order {} is beyond what the dense {} takes with 32-bit workspace indices (at most {})", n, routine, limit));
  }
  return static_cast<int>(n);
}

Index largest_order(double a, double b, double c) {
  // a·n² + b·n + c = 2³¹ − 1, the positive root, rounded down with a margin for LAPACK's block sizes.
  const double top = 2147483647.0 - c;
  return static_cast<Index>((-b + std::sqrt(b * b + 4 * a * top)) / (2 * a)) - 64;
}

void require_success(int info, std::string_view routine, std::string_view meaning) {
  if (info == 0) return;
  if (info == LAPACK_WORK_MEMORY_ERROR || info == LAPACK_TRANSPOSE_MEMORY_ERROR) throw std::bad_alloc();
  if (info < 0) throw NotConverged(fmt::format("{}: argument {} was refused (not finite, or out of range)", routine, -info));
  throw NotConverged(fmt::format("{}: {} (info = {})", routine, meaning, info));
}

}  // namespace gyromode::lapack
