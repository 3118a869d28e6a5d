#include "gyromode/sparse/deflated.h"

#include "gyromode/lapack/multiply.h"

#include <Eigen/Cholesky>

namespace gyromode::sparse {

namespace {

std::vector<Index> columns_of(const std::vector<bool>& across, bool wanted) {
  std::vector<Index> all;
  for (std::size_t k = 0; k < across.size(); ++k) {
    if (across[k] == wanted) all.push_back(static_cast<Index>(k));
  }
  return all;
}

struct Parts {
  Matrix out, weight, e_out;
  Index drifting = 0;  // the last columns
};

// Of states (q, q̇).
Parts of_pairs(const ZeroMotions& z, Index n) {
  const Index r = z.nullity(), d = z.drift.cols();
  Parts p{Matrix::Zero(2 * n, r + d), Matrix::Zero(2 * n, r + d), Matrix::Zero(2 * n, r + d), d};
  p.out.topLeftCorner(n, r) = z.n;
  p.weight.topLeftCorner(n, r) = z.mn;
  p.out.rightCols(d) << z.response, z.drift;
  p.e_out.rightCols(d) << z.held, z.mn * (z.mn.transpose() * z.drift);  // MN₀, N₀ being in the span of N
  return p;
}

// Of states (x, ẏ) in the order of coordinates, x of the group `leading`: N of that group, and drift of the other.
Parts of_groups(const ZeroMotions& z, Index n, bool leading) {
  const std::vector<Index> still = columns_of(z.across, leading), drift = columns_of(z.drift_across, !leading);
  const Index r = static_cast<Index>(still.size()), d = static_cast<Index>(drift.size());
  Parts p{Matrix::Zero(n, r + d), Matrix::Zero(n, r + d), Matrix::Zero(n, r + d), d};
  p.out.leftCols(r) = z.n(Eigen::all, still);
  p.weight.leftCols(r) = z.mn(Eigen::all, still);
  const Matrix n0 = z.drift(Eigen::all, drift);
  p.out.rightCols(d) = n0 + z.response(Eigen::all, drift);  // rows of the other group, and of the leading one
  p.e_out.rightCols(d) = z.held(Eigen::all, drift) + z.mn * (z.mn.transpose() * n0);
  return p;
}

}  // namespace

Deflated::Deflated(std::unique_ptr<Inverse> of, const Groups& groups, const ZeroMotions& zero) : of_(std::move(of)) {
  Parts p = groups.partition ? of_groups(zero, zero.n.rows(), of_->leading_group() == 1) : of_pairs(zero, zero.n.rows());
  const Index d = p.drifting;
  if (d > 0) {
    const Matrix drift = p.out.rightCols(d), e_drift = p.e_out.rightCols(d), gram = drift.transpose() * e_drift;
    p.weight.rightCols(d) = e_drift * gram.llt().solve(Matrix::Identity(d, d));
  }
  out_ = groups.partition ? of_->states(p.out) : p.out;
  weight_ = groups.partition ? of_->states(p.weight) : p.weight;
  e_out_ = groups.partition ? of_->states(p.e_out) : p.e_out;
}

States Deflated::without_zero(States w) const {
  const Matrix c = lapack::multiply_tn(weight_, w.x);
  lapack::multiply_into(w.x, -1, out_, false, c, false, 1);
  lapack::multiply_into(w.ex, -1, e_out_, false, c, false, 1);
  return w;
}

}  // namespace gyromode::sparse
