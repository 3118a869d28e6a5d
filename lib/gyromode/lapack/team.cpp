#include "gyromode/lapack/team.h"

#include <cblas.h>

#include <algorithm>

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

namespace gyromode::lapack {

namespace {

constexpr int spins = 2000;

// The cores this thread may run on but the one it is on. A new thread starts on the core of its parent, and may share it for longer than the work takes.
#ifdef __linux__
using Cores = cpu_set_t;
Cores other_cores() {
  Cores cores;
  CPU_ZERO(&cores);
  if (sched_getaffinity(0, sizeof cores, &cores) == 0) CPU_CLR(sched_getcpu(), &cores);
  return cores;
}
void stay_on(const Cores& cores) {
  if (CPU_COUNT(&cores) > 0) pthread_setaffinity_np(pthread_self(), sizeof cores, &cores);
}
#else
struct Cores {};
Cores other_cores() { return {}; }
void stay_on(const Cores&) {}
#endif

}  // namespace

Team::Team(int threads) {
  if (threads < 2) return;
  blas_threads_ = openblas_get_num_threads();
  openblas_set_num_threads(1);
  const Cores cores = other_cores();
  for (int part = 1; part < threads; ++part) {
    others_.emplace_back([this, part, cores] {
      stay_on(cores);
      serve(part);
    });
  }
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
