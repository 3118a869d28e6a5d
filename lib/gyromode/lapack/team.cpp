#include "gyromode/lapack/team.h"

#include <cblas.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#ifdef __linux__
#include <pthread.h>
#include <sched.h>
#endif

namespace gyromode::lapack {

namespace {

constexpr int busy_spins = 2000;  // some microseconds: a yield may cost a whole time slice where others want the processor
constexpr int spins = 2000;
constexpr std::uint64_t first_of_next_round = 1 << 16;
constexpr Index worth_sharing = 512;  // order of matrices below which a second thread gains nothing

// The cores this thread may run on but the one it is on. A new thread starts on the core of its parent, and may share
// it for longer than the work takes.
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

// Until `done` is true, or `yields` were given away.
template <class Condition>
void wait_for(const Condition& done, int yields) {
  for (int spin = 0; spin < busy_spins; ++spin) {
    if (done()) return;
  }
  for (int spin = 0; spin < yields && !done(); ++spin) std::this_thread::yield();
}

}  // namespace

Team::Team(int threads) {
  if (threads < 2) return;
  size_ = threads;
  next_ = static_cast<std::uint64_t>(threads);  // round 0, all of it taken
  blas_threads_ = openblas_get_num_threads();
  openblas_set_num_threads(1);
  const Cores cores = other_cores();
  for (int part = 1; part < threads; ++part) {
    others_.emplace_back([this, cores] {
      stay_on(cores);
      serve();
    });
  }
}

Team::~Team() {
  if (others_.empty()) return;
  stop_ = true;
  next_.fetch_add(first_of_next_round);  // no part of it is free, but it wakes
  next_.notify_all();
  openblas_set_num_threads(blas_threads_);
}

// Takes a part of the round `seen`, where one is free, and brings `seen` up to date.
bool Team::work_on_next_part(std::uint64_t& seen) {
  seen = next_.load(std::memory_order_acquire);
  while (static_cast<int>(seen % first_of_next_round) < size()) {
    if (!next_.compare_exchange_weak(seen, seen + 1, std::memory_order_acq_rel, std::memory_order_acquire)) continue;
    (*work_)(static_cast<int>(seen % first_of_next_round));
    finished_.fetch_add(1, std::memory_order_release);
    return true;
  }
  return false;
}

void Team::serve() {
  std::uint64_t seen = 0;
  while (!stop_) {
    if (work_on_next_part(seen)) continue;
    wait_for([&] { return next_.load(std::memory_order_acquire) != seen; }, spins);
    next_.wait(seen, std::memory_order_acquire);
  }
}

void Team::run(const std::function<void(int)>& work) {
  if (others_.empty()) return work(0);
  work_ = &work;
  finished_.store(0, std::memory_order_relaxed);
  const std::uint64_t last = next_.load(std::memory_order_relaxed);
  next_.store((last / first_of_next_round + 1) * first_of_next_round, std::memory_order_release);
  next_.notify_all();
  std::uint64_t seen = 0;
  while (work_on_next_part(seen)) continue;
  wait_for([&] { return finished_.load(std::memory_order_acquire) == size(); }, std::numeric_limits<int>::max());
}

int threads_for(Index n) {
  constexpr int most = 8;
  return n < worth_sharing ? 1 : std::min(openblas_get_num_threads(), most);
}

BlasOnOneThread::BlasOnOneThread() : before_(openblas_get_num_threads()) { openblas_set_num_threads(1); }
BlasOnOneThread::~BlasOnOneThread() { openblas_set_num_threads(before_); }

void use_one_thread_for_small(Index n) {
  const bool said = std::getenv("OPENBLAS_NUM_THREADS") || std::getenv("GOTO_NUM_THREADS") || std::getenv("OMP_NUM_THREADS");
  if (!said && n < worth_sharing) openblas_set_num_threads(1);
}

}  // namespace gyromode::lapack
