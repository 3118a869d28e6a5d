#include "gyromode/sparse/lanczos.h"

#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/sparse/orthonormal.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::sparse {

Matrix random_shapes(Index n, Index width, unsigned draw) {
  std::mt19937_64 bits(20090 + draw);
  Matrix x(n, width);
  for (Index k = 0; k < x.size(); ++k) x.data()[k] = std::ldexp(static_cast<double>(bits() >> 11), -52) - 1;
  return x;
}

Lanczos::Lanczos(const Inverse& inverse, Index n, Index width, Index most)
    : inverse_(inverse),
      rough_(inverse.rough_products()),
      n_(n),
      width_(width),
      most_(std::max(most, 4 * width)),
      u_(inverse.length(), 0),
      eu_(inverse.length(), 0) {
  refresh(width);
}

// Against U twice, and among themselves: W = U onto + (what is returned) rest. What is left of a column below 10⁻¹⁰ of
// it is rounding. Of the first blocks, which hold the lowest modes, E W is carried along as the operator gave it: a
// product with K would have rounding of ε‖K‖‖w‖². What is carried drifts away by a factor from block to block, so that
// later ones, which hold little of the lowest modes, have it by products.
States Lanczos::orthonormalised(States w, Matrix& onto, Matrix& rest) const {
  const auto u = u_.leftCols(size_);
  const Index m = w.x.cols();
  onto = Matrix::Zero(size_, m);
  Vector size(m);
  for (Index j = 0; j < m; ++j) size(j) = std::sqrt(std::max(0.0, w.x.col(j).dot(w.ex.col(j))));
  const double largest = m > 0 ? size.maxCoeff() : 0;
  const Vector scale = size.unaryExpr([&](double s) { return s > 1e-14 * largest && s > 0 ? s : 1.0; });
  for (Matrix* a : {&w.x, &w.ex}) *a = *a * scale.cwiseInverse().asDiagonal();
  rest = Matrix::Identity(m, m);
  for (const double least : {1e-20, 1e-4}) {
    const Matrix c = lapack::multiply_tn(u, w.ex);
    lapack::multiply_into(w.x, -1, u, false, c, false, 1);
    onto += c * rest;
    if (carried())
      lapack::multiply_into(w.ex, -1, eu_.leftCols(size_), false, c, false, 1);
    else
      w.ex = inverse_.inner(w.x);
    const Matrix gram = lapack::multiply_tn(w.x, w.ex), fresh = orthonormal_combinations(gram, least),
                 t = fresh.leftCols(std::min(fresh.cols(), inverse_.dimension() - size_));
    w.x = w.x * t;
    w.ex = w.ex * t;
    rest = (t.transpose() * gram) * rest;
  }
  if (carried()) inverse_.settle(w);
  onto = onto * scale.asDiagonal();
  rest = rest * scale.asDiagonal();
  return w;
}

void Lanczos::append(const States& block) {
  const Index m = block.x.cols();
  if (size_ + m > u_.cols()) {
    const Index room = std::max(most_, size_ + m);
    u_.conservativeResize(inverse_.length(), room);
    h_.conservativeResize(room, room);
  }
  u_.middleCols(size_, m) = block.x;
  ++blocks_;
  if (!carried()) {
    eu_.resize(0, 0);
  } else {
    if (size_ + m > eu_.cols()) eu_.conservativeResize(inverse_.length(), std::max(size_ + m, std::min(most_, most_carried * width_)));
    eu_.middleCols(size_, m) = block.ex;
  }
  last_ = m;
  size_ += m;
}

void Lanczos::refresh(Index width) {
  Matrix onto;
  next_ = orthonormalised(inverse_.start(random_shapes(n_, width, draws_++)), onto, rest_);
  rest_.resize(0, 0);
  applied_ += width;
  last_ = 0;
}

bool Lanczos::step() {
  if (next_.x.cols() == 0) return false;
  if (size_ + next_.x.cols() > most_) restart();
  const Index first = size_;
  append(next_);
  const Index m = last_;
  States w = inverse_.apply(next_);
  applied_ += m;
  Matrix onto;
  next_ = orthonormalised(std::move(w), onto, rest_);
  const double sign = inverse_.skew() ? -1 : 1;
  h_.block(0, first, size_, m) = onto;
  h_.block(first, 0, m, first) = sign * onto.topRows(first).transpose();
  h_.block(first, first, m, m) = 0.5 * (onto.bottomRows(m) + sign * onto.bottomRows(m).transpose());
  return next_.x.cols() > 0;
}

Lanczos::Ritz Lanczos::ritz() const {
  const Index p = size_;
  const Matrix h = h_.topLeftCorner(p, p);
  Ritz r;
  std::vector<Index> order;
  const auto sorted = [&](const Vector& values, bool positive) {
    for (Index k = 0; k < values.size(); ++k) {
      if (!positive || values(k) > 0) order.push_back(k);
    }
    std::sort(order.begin(), order.end(), [&](Index a, Index b) { return std::abs(values(a)) > std::abs(values(b)); });
  };
  if (inverse_.skew()) {  // H z = −jθ z of jH z = θ z
    const lapack::HermitianEigen e = lapack::hermitian_eigen(Complex(0, 1) * h);
    sorted(e.values, true);
    const double root2 = std::sqrt(2.0);
    r.theta = e.values(order);
    r.re = root2 * e.vectors(Eigen::all, order).real();
    r.im = root2 * e.vectors(Eigen::all, order).imag();
  } else {
    const lapack::SymmetricEigen e = lapack::symmetric_eigen(h);
    sorted(e.values, false);
    r.theta = e.values(order);
    r.re = e.vectors(Eigen::all, order);
  }
  Vector squares = (rest_ * r.re.bottomRows(last_)).colwise().squaredNorm();
  if (r.im.size() > 0) squares = 0.5 * (squares + Vector((rest_ * r.im.bottomRows(last_)).colwise().squaredNorm()));
  r.residual = squares.cwiseSqrt();
  return r;
}

Matrix Lanczos::combined(const Matrix& coefficients) const { return lapack::multiply(u_.leftCols(size_), coefficients); }

Matrix Lanczos::refined(const Matrix& states, const Ritz& ritz, const std::vector<Index>& which) const {
  const auto u = u_.leftCols(size_);
  States w = inverse_.apply({states, inverse_.inner(states)});
  const Matrix c = lapack::multiply_tn(u, w.ex);
  Matrix others = Matrix::Zero(size_, c.cols());
  for (const Matrix* y : {&ritz.re, &ritz.im}) {
    if (y->size() == 0) continue;
    Matrix part = y->transpose() * c;
    for (std::size_t k = 0; k < which.size(); ++k) part(which[k], static_cast<Index>(k)) = 0;
    others += *y * part;
  }
  lapack::multiply_into(w.x, -1, u, false, others, false, 1);
  return std::move(w.x);
}

// The outermost half is kept; what is next stays next, and its products with what is kept come with the next step.
void Lanczos::restart() {
  blocks_ = most_carried + 1;
  eu_.resize(0, 0);
  const Ritz r = ritz();
  const bool pairs = r.im.size() > 0;
  const Index kept = std::min<Index>(r.theta.size(), (most_ / 2) / (pairs ? 2 : 1));
  Matrix y(size_, pairs ? 2 * kept : kept);
  if (pairs)
    y << r.re.leftCols(kept), r.im.leftCols(kept);
  else
    y = r.re.leftCols(kept);
  const Matrix h = y.transpose() * h_.topLeftCorner(size_, size_) * y;
  constexpr Index rows = 4096;  // in pieces, so that no second basis is needed
  for (Index i = 0; i < u_.rows(); i += rows) {
    const Index m = std::min(rows, u_.rows() - i);
    const Matrix piece = lapack::multiply(u_.block(i, 0, m, size_), y);
    u_.block(i, 0, m, y.cols()) = piece;
  }
  size_ = y.cols();
  h_.topLeftCorner(size_, size_) = inverse_.skew() ? Matrix(0.5 * (h - h.transpose())) : Matrix(0.5 * (h + h.transpose()));
}

}  // namespace gyromode::sparse
