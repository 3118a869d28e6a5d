#pragma once

#include "gyromode/lapack/team.h"

#include <memory>

namespace gyromode::sparse {

/// While it exists the BLAS uses one thread, where n coordinates have fronts so small that more gain nothing (theory
/// sparse §1); else null.
inline std::unique_ptr<lapack::BlasOnOneThread> few_blas_threads(Index n) {
  constexpr Index large_fronts = 300000;
  return n < large_fronts ? std::make_unique<lapack::BlasOnOneThread>() : nullptr;
}

}  // namespace gyromode::sparse
