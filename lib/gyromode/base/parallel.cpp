#include "gyromode/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace gyromode {

namespace {

unsigned processors() {
  if (const char* asked = std::getenv("OMP_NUM_THREADS")) {
    const int n = std::atoi(asked);
    if (n > 0) return static_cast<unsigned>(n);
  }
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

bool for_each_in_parallel(Index count, const std::function<void(Index)>& work, const std::function<bool(Index)>& continues) {
  std::atomic<Index> next{0}, done{0};
  std::atomic<bool> stop{false};
  std::exception_ptr thrown;
  std::mutex guard;
  const auto one = [&] {
    const Index k = next.fetch_add(1);
    if (stop || k >= count) return false;
    try {
      work(k);
    } catch (...) {
      const std::lock_guard lock(guard);
      if (!thrown) thrown = std::current_exception();
      stop = true;
    }
    ++done;
    return true;
  };
  {
    std::vector<std::jthread> others;
    const auto threads = std::min<Index>(static_cast<Index>(processors()), count);
    for (Index t = 1; t < threads; ++t) {
      others.emplace_back([&] {
        while (one()) {
        }
      });
    }
    while (one()) {
      if (continues && !continues(done)) stop = true;
    }
  }
  if (thrown) std::rethrow_exception(thrown);
  return done >= count;
}

}  // namespace gyromode
