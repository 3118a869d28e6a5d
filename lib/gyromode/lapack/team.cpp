#include "gyromode/lapack/team.h"

#include <cblas.h>

#include <algorithm>

namespace gyromode::lapack {

namespace {

constexpr int spins = 2000;

}  // namespace

Team::Team(int threads) {
  if (threads < 2) return;
  blas_threads_ = openblas_get_num_threads();
  openblas_set_num_threads(1);
  for (int part = 1; part < threads; ++part) others_.emplace_back([this, part] { serve(part); });
}

Team::~Team() {
  if (others_.empty()) return;
  stop_ = true;
  round_.fetch_add(1);
  round_.notify_all();
  openblas_set_num_threads(blas_threads_);
}

void Team::serve(int part) {
  unsigned seen = 0;
  for (;;) {
    for (int spin = 0; spin < spins && round_.load(std::memory_order_acquire) == seen; ++spin) std::this_thread::yield();
    round_.wait(seen);
    seen = round_.load(std::memory_order_acquire);
    if (stop_) return;
    (*work_)(part);
    finished_.fetch_add(1, std::memory_order_release);
  }
}

void Team::run(const std::function<void(int)>& work) {
  if (others_.empty()) return work(0);
  work_ = &work;
  finished_.store(0);
  round_.fetch_add(1, std::memory_order_release);
  round_.notify_all();
  work(0);
  while (finished_.load(std::memory_order_acquire) + 1 < size()) std::this_thread::yield();
}

int threads_for(Index n) {
  constexpr Index worth_it = 512;
  constexpr int most = 8;
  return n < worth_it ? 1 : std::min(openblas_get_num_threads(), most);
}

}  // namespace gyromode::lapack
