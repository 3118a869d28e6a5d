#include "gyromode/dense/even_pencil.h"

#include "gyromode/dense/basis.h"
#include "gyromode/dense/root_groups.h"
#include "gyromode/lapack/multiply.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// A limit within a factor 10 below `limit` that tears no pair or quadruple (roots of equal modulus) apart: the middle of the widest gap there, if it is
// wide enough; 0 where there is none.
double gap_below(const ComplexVector& lambda, double limit) {
  std::vector<double> moduli;
  for (const Complex& z : lambda) moduli.push_back(std::abs(z));
  std::sort(moduli.begin(), moduli.end());
  double best = 1.01;
  double place = 0;
  for (std::size_t i = 0; i + 1 < moduli.size(); ++i) {
    const double low = std::max(moduli[i], 0.1 * limit);
    const double high = std::min(moduli[i + 1], limit);
    if (moduli[i] > limit || !(high > best * low)) continue;
    best = high / low;
    place = std::sqrt(low * high);
  }
  return place;
}

Index nearest(const ComplexVector& lambda, Complex to) {
  Index at = 0;
  (lambda.array() - to).abs().minCoeff(&at);
  return at;
}

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w, int depth) {
  constexpr double small_ratio = 1e-2;
  constexpr int deepest = 12;
  if (lambda.size() == 0) return {};
  const double largest = lambda.cwiseAbs().maxCoeff();
  const double limit = depth < deepest ? gap_below(lambda, small_ratio * largest) : 0;
  std::vector<Index> small, upper;
  std::vector<EvenRoot> roots;
  for (Index i = 0; i < lambda.size(); ++i) {
    if (std::abs(lambda(i)) < limit) {
      small.push_back(i);
    } else if (lambda(i).imag() == 0) {
      if (lambda(i).real() > 0) roots.push_back({lambda(i), w.col(i), w.col(nearest(lambda, -lambda(i)))});
    } else if (lambda(i).imag() > 0) {
      upper.push_back(i);
    }
  }
  if (small.size() % 2 != 0) return roots_of(p, lambda, w, deepest);  // a pair torn by the limit: everything at this level
  for (EvenRoot& r : roots_of_groups(p, lambda(upper), w(Eigen::all, upper))) roots.push_back(std::move(r));
  if (!small.empty()) {  // in a basis of their span: the error of the plain eigenvalues is relative to the largest
    const Matrix v = real_basis(w, lambda, small);
    const EvenPencil inner = p.projected(v);
    const auto e = inner.plain_eigen();
    for (EvenRoot& r : roots_of(inner, e.values, e.vectors, depth + 1)) {
      roots.push_back({r.lambda, v * r.w, r.left.size() > 0 ? ComplexVector(v * r.left) : ComplexVector()});
    }
  }
  return roots;
}

}  // namespace

EvenPencil EvenPencil::of_second_order(Matrix gamma, Matrix k) {
  EvenPencil p(std::move(gamma), std::move(k));
  p.second_order_ = true;
  return p;
}

Matrix EvenPencil::s_times(const Matrix& w) const {
  if (!second_order_) return lapack::multiply(s_, w);
  const Index n = s_.rows();
  Matrix y(w.rows(), w.cols());
  y.topRows(n) = lapack::multiply(s_, w.topRows(n)) + w.bottomRows(n);
  y.bottomRows(n) = -w.topRows(n);
  return y;
}

Matrix EvenPencil::e_times(const Matrix& w) const {
  if (!second_order_) return lapack::multiply(e_, w);
  const Index n = s_.rows();
  Matrix y(w.rows(), w.cols());
  y.topRows(n) = lapack::multiply(e_, w.topRows(n));
  y.bottomRows(n) = w.bottomRows(n);
  return y;
}

lapack::GeneralEigen EvenPencil::plain_eigen() const {
  if (!second_order_) return lapack::general_eigen(Matrix(-s_.partialPivLu().solve(e_)));
  const Index n = s_.rows();
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -e_;
  a.bottomRightCorner(n, n) = -s_;
  return lapack::general_eigen(std::move(a));
}

EvenPencil EvenPencil::projected(const Matrix& v) const {
  const Matrix s = lapack::multiply_tn(v, s_times(v));
  const Matrix e = lapack::multiply_tn(v, e_times(v));
  return {0.5 * (s - s.transpose()), 0.5 * (e + e.transpose())};
}

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w) { return roots_of(p, lambda, w, 0); }

}  // namespace gyromode::dense
