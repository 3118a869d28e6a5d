#include "gyromode/dense/skew_multiply.h"

#include "gyromode/lapack/library.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>
#include <vector>

namespace gyromode::dense {

namespace {

// The columns [from, to) of the lower triangle `a` (n × n, leading dimension `stride`) and their mirror images.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
__attribute__((target_clones("arch=x86-64-v3", "default"), optimize("O3", "fast-math")))
#endif
void multiply_columns(const double* a, Index stride, Index n, Index from, Index to, const double* v, double* y) {
  std::fill(y, y + n, 0.0);
  Index j = from;
  for (; j + 4 <= to; j += 4) {  // four columns at a time: y and v are loaded once for the four
    for (Index c = j; c < j + 4; ++c) {
      for (Index i = c + 1; i < j + 4; ++i) {
        y[i] += a[c * stride + i] * v[c];
        y[c] -= a[c * stride + i] * v[i];
      }
    }
    const double *a0 = a + j * stride, *a1 = a0 + stride, *a2 = a1 + stride, *a3 = a2 + stride;
    const double v0 = v[j], v1 = v[j + 1], v2 = v[j + 2], v3 = v[j + 3];
    double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
    for (Index i = j + 4; i < n; ++i) {
      const double vi = v[i];
      y[i] += a0[i] * v0 + a1[i] * v1 + a2[i] * v2 + a3[i] * v3;
      s0 += a0[i] * vi;
      s1 += a1[i] * vi;
      s2 += a2[i] * vi;
      s3 += a3[i] * vi;
    }
    y[j] -= s0;
    y[j + 1] -= s1;
    y[j + 2] -= s2;
    y[j + 3] -= s3;
  }
  for (; j < to; ++j) {
    for (Index i = j + 1; i < n; ++i) {
      y[i] += a[j * stride + i] * v[j];
      y[j] -= a[j * stride + i] * v[i];
    }
  }
}

}  // namespace

void skew_multiply(const Matrix& z, Index first, const double* v, double* y) {
  const Index n = z.rows() - first;
  multiply_columns(z.data() + first * (z.rows() + 1), z.rows(), n, 0, n, v, y);
}

struct SkewMultiply::Team {
  struct Task {
    const double* a = nullptr;
    Index stride = 0, n = 0;
    const double* v = nullptr;
  };

  Team(Index largest, int threads) : results(static_cast<std::size_t>(threads), Vector(largest)) {
    for (int part = 1; part < threads; ++part) workers.emplace_back([this, part] { serve(part); });
  }

  ~Team() {
    stop = true;
    round.fetch_add(1);
    round.notify_all();
  }

  // Column where `part` begins: the triangle right of column c has the share (1 − c/n)² of the area.
  Index begin_of(int part) const {
    const double left = 1 - static_cast<double>(part) / static_cast<double>(results.size());
    return part == static_cast<int>(results.size()) ? task.n : static_cast<Index>(static_cast<double>(task.n) * (1 - std::sqrt(left)));
  }

  void work(int part) {
    multiply_columns(task.a, task.stride, task.n, begin_of(part), begin_of(part + 1), task.v, results[static_cast<std::size_t>(part)].data());
  }

  void serve(int part) {
    unsigned seen = 0;
    for (;;) {
      for (int spin = 0; spin < 2000 && round.load(std::memory_order_acquire) == seen; ++spin) std::this_thread::yield();
      round.wait(seen);
      seen = round.load(std::memory_order_acquire);
      if (stop) return;
      work(part);
      finished.fetch_add(1, std::memory_order_release);
    }
  }

  void run(const Task& given) {
    task = given;
    finished.store(0);
    round.fetch_add(1, std::memory_order_release);
    round.notify_all();
    work(0);
    while (finished.load(std::memory_order_acquire) + 1 < static_cast<int>(results.size())) std::this_thread::yield();
  }

  Task task;
  std::vector<Vector> results;
  std::atomic<unsigned> round{0};
  std::atomic<int> finished{0};
  std::atomic<bool> stop{false};
  std::vector<std::jthread> workers;  // last: joined first
};

SkewMultiply::SkewMultiply(Index largest) {
  constexpr Index worth_it = 512;
  const int threads = std::min(lapack::threads(), 8);
  if (threads > 1 && largest >= worth_it) team_ = std::make_unique<Team>(largest, threads);
}

SkewMultiply::~SkewMultiply() = default;

void SkewMultiply::operator()(const Matrix& z, Index first, const double* v, double* y) {
  constexpr Index worth_it = 384;
  const Index n = z.rows() - first;
  if (!team_ || n < worth_it) {
    skew_multiply(z, first, v, y);
    return;
  }
  team_->run({z.data() + first * (z.rows() + 1), z.rows(), n, v});
  Eigen::Map<Vector> sum(y, n);
  sum = team_->results[0].head(n);
  for (std::size_t part = 1; part < team_->results.size(); ++part) sum += team_->results[part].head(n);
}

}  // namespace gyromode::dense
