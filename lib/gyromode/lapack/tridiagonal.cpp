#include "gyromode/lapack/tridiagonal.h"

#include "gyromode/lapack/divide_conquer.h"
#include "gyromode/lapack/status.h"

#include "gyromode/lapack/lapacke_complex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode::lapack {

namespace {

// A power of two near the largest entry where its square would leave the range of double, else 1.
double unit_of(const Matrix& a) {
  double largest = 0;
  for (Index j = 0; j < a.cols(); ++j) largest = std::max(largest, a.col(j).tail(a.rows() - j).lpNorm<Eigen::Infinity>());
  const bool within = largest == 0 || (largest > 1e-140 && largest < 1e140);
  return within || !std::isfinite(largest) ? 1 : std::exp2(std::round(std::log2(largest)));
}

}  // namespace

Tridiagonal::Tridiagonal(Matrix a) : diagonal_(a.rows()), subdiagonal_(std::max<Index>(a.rows() - 1, 0)) {
  const Index n = a.rows();
  unit_ = unit_of(a);
  if (unit_ != 1) a /= unit_;
  q_ = {std::move(a), Vector(subdiagonal_.size()), 1};
  if (n == 0) return;
  const int order = dimension(n, "dsytrd");
  const auto reduce = [&](double* work, int length) {
    const int info = LAPACKE_dsytrd_work(LAPACK_COL_MAJOR, 'L', order, q_.vectors.data(), order, diagonal_.data(), subdiagonal_.data(),
                                         q_.tau.data(), work, length);
    require_success(info, "dsytrd", "");
  };
  double length = 0;
  reduce(&length, -1);
  Vector work(static_cast<Index>(length));
  reduce(work.data(), dimension(work.size(), "dsytrd"));
}

Index Tridiagonal::below(double bound) const {
  const double shift = bound / unit_;
  const double smallest = std::numeric_limits<double>::min();
  Index count = 0;
  double pivot = 1;
  for (Index i = 0; i < size(); ++i) {
    const double e = i == 0 ? 0 : subdiagonal_(i - 1);
    pivot = diagonal_(i) - shift - e * e / pivot;
    if (std::abs(pivot) < smallest) pivot = -smallest;
    if (pivot < 0) ++count;
  }
  return count;
}

SymmetricEigen Tridiagonal::eigen() const {
  SymmetricEigen e = tridiagonal_eigen(diagonal_, subdiagonal_);
  multiply_left(q_, e.vectors);
  e.values *= unit_;
  return e;
}

}  // namespace gyromode::lapack
