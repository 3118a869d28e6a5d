#include "gyromode/dense/general/skew_multiply.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// The columns [from, to) of the lower triangle `a` (n × n, leading dimension `stride`) and their mirror images.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
// Sums in any order, so that they fill vector registers; NaN and infinity stay what they are.
__attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default"),
               optimize("O3", "associative-math", "no-signed-zeros", "no-trapping-math")))
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

SkewMultiply::SkewMultiply(lapack::Team& team, Index largest)
    : team_(team), results_(static_cast<std::size_t>(team.size()), Vector(largest)) {}

void SkewMultiply::operator()(const Matrix& z, Index first, const double* v, double* y) {
  constexpr Index worth_it = 384;
  const Index n = z.rows() - first;
  if (team_.size() == 1 || n < worth_it) return skew_multiply(z, first, v, y);
  const double* a = z.data() + first * (z.rows() + 1);
  team_.run([&](int part) {
    multiply_columns(a, z.rows(), n, equal_area(n, part, team_.size()), equal_area(n, part + 1, team_.size()), v,
                     results_[static_cast<std::size_t>(part)].data());
  });
  Eigen::Map<Vector> sum(y, n);
  sum = results_[0].head(n);
  for (std::size_t part = 1; part < results_.size(); ++part) sum += results_[part].head(n);
}

Index equal_area(Index n, int part, int parts) {
  if (part == parts) return n;
  // right of column c lies the share (1 − c/n)² of a triangle
  const double left = 1 - static_cast<double>(part) / static_cast<double>(parts);
  return static_cast<Index>(static_cast<double>(n) * (1 - std::sqrt(left)));
}

}  // namespace gyromode::dense
