#pragma once

#include "gyromode/base/types.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace gyromode::lapack {

/// As many threads as the BLAS uses, for work of some ten microseconds at a time: between two calls of run() the others
/// spin for a while before they sleep. While a team of more than one exists the BLAS itself uses one thread, and may be
/// called by every member: its own idle threads would compete for the cores.
class Team {
 public:
  explicit Team(int threads);
  ~Team();
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;

  int size() const { return size_; }
  /// Rows or columns begin(n, part) … + count(n, part) of n belong to `part` where all cost the same.
  Index begin(Index n, int part) const { return n * part / size(); }
  Index count(Index n, int part) const { return begin(n, part + 1) - begin(n, part); }
  /// Calls work(0), …, work(size() − 1), each once, and returns when all have. A part goes to the first thread that is
  /// free: where the others do not get a processor, the caller does everything. `work` must not throw.
  void run(const std::function<void(int)>& work);

 private:
  bool work_on_next_part(std::uint64_t& seen);
  void serve();

  int size_ = 1;
  const std::function<void(int)>* work_ = nullptr;
  std::atomic<std::uint64_t> next_{0};  ///< round and, in the low bits, the first part of it that nobody has taken
  std::atomic<int> finished_{0};
  std::atomic<bool> stop_{false};
  int blas_threads_ = 1;              ///< to return to
  std::vector<std::jthread> others_;  ///< last: joined first
};

/// How many threads a team for matrices of order n should have: those of the BLAS, or one where the work is too little
/// to share.
int threads_for(Index n);

/// While one exists the BLAS uses one thread: for work that is shared out in larger pieces, which call it side by side.
class BlasOnOneThread {
 public:
  BlasOnOneThread();
  ~BlasOnOneThread();
  BlasOnOneThread(const BlasOnOneThread&) = delete;
  BlasOnOneThread& operator=(const BlasOnOneThread&) = delete;

 private:
  int before_;
};

/// Keeps the BLAS of this process on one thread where matrices of order n are too little work to share: threads that
/// wait for work compete with whatever else the machine does. Nothing changes where the environment says how many
/// (OPENBLAS_NUM_THREADS, GOTO_NUM_THREADS, OMP_NUM_THREADS). For a program; a library leaves it to its caller.
void use_one_thread_for_small(Index n);

}  // namespace gyromode::lapack
