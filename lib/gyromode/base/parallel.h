#pragma once

#include "gyromode/base/types.h"

#include <functional>

namespace gyromode {

/// Calls work(0) … work(count − 1), each once, on as many threads as the machine has processors (OMP_NUM_THREADS says
/// otherwise), and returns when all have; what the first of them threw is thrown. `continues` is called by the thread
/// that asked, with the number done: false ends it, and the result is then false. Pieces are taken in order.
bool for_each_in_parallel(Index count, const std::function<void(Index)>& work, const std::function<bool(Index)>& continues = {});

}  // namespace gyromode
