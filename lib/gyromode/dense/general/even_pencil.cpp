#include "gyromode/dense/general/even_pencil.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/basis.h"
#include "gyromode/dense/general/root_groups.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/triangular.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode::dense {

namespace {

// A limit below `limit` that tears no pair or quadruple (roots of equal modulus) apart: the middle of the widest gap
// within a factor 10 below it, if it is wide enough, or of one farther down that is wider than a factor of 100, as
// between the fast and the slow motions of a strong spin; 0 where there is none.
double gap_below(const ComplexVector& lambda, double limit) {
  std::vector<double> moduli;
  for (const Complex& z : lambda) moduli.push_back(std::abs(z));
  std::sort(moduli.begin(), moduli.end());
  constexpr double wide = 100;
  double best = 1.01, widest = wide;
  double place = 0, wide_place = 0;
  for (std::size_t i = 0; i + 1 < moduli.size() && moduli[i] <= limit; ++i) {
    const double above = std::min(moduli[i + 1], limit);
    const double low = std::max(moduli[i], 0.1 * limit);
    if (above > best * low) {
      best = above / low;
      place = std::sqrt(low * above);
    }
    if (moduli[i] > 0 && above > widest * moduli[i]) {
      widest = above / moduli[i];
      wide_place = std::sqrt(moduli[i]) * std::sqrt(above);
    }
  }
  return wide_place > 0 ? wide_place : place;
}

// For every real root σ > 0 a root −σ, no two the same; the root itself where there is none left.
std::vector<std::pair<Index, Index>> real_pairs(const ComplexVector& lambda, const std::vector<Index>& real) {
  std::vector<Index> positive, negative;
  for (const Index i : real) (lambda(i).real() > 0 ? positive : negative).push_back(i);
  const auto by_size = [&](Index a, Index b) { return std::abs(lambda(a)) < std::abs(lambda(b)); };
  std::sort(positive.begin(), positive.end(), by_size);
  std::sort(negative.begin(), negative.end(), by_size);
  std::vector<std::pair<Index, Index>> pairs;
  for (const Index i : positive) {
    auto partner = negative.empty() ? negative.end() : negative.begin();
    if (positive.size() != negative.size() + pairs.size()) {  // one of a pair is elsewhere: the nearest
      partner = std::min_element(negative.begin(), negative.end(),
                                 [&](Index a, Index b) { return std::abs(lambda(a) + lambda(i)) < std::abs(lambda(b) + lambda(i)); });
    }
    if (partner == negative.end()) {
      pairs.emplace_back(i, i);
      continue;
    }
    pairs.emplace_back(i, *partner);
    negative.erase(partner);
  }
  return pairs;
}

// The vectors of a level in the coordinates of the whole, all at once.
void expand(const Matrix& basis, std::vector<EvenRoot>& roots) {
  Index lefts = 0;
  for (const EvenRoot& r : roots) lefts += r.left.size() > 0 ? 1 : 0;
  const Index count = static_cast<Index>(roots.size());
  ComplexMatrix inner(basis.cols(), count + lefts);
  Index at = count;
  for (Index k = 0; k < count; ++k) {
    const EvenRoot& r = roots[static_cast<std::size_t>(k)];
    inner.col(k) = r.w;
    if (r.left.size() > 0) inner.col(at++) = r.left;
  }
  const Matrix re = lapack::multiply(basis, inner.real()), im = lapack::multiply(basis, inner.imag());
  at = count;
  for (Index k = 0; k < count; ++k) {
    EvenRoot& r = roots[static_cast<std::size_t>(k)];
    r.w = re.col(k) + Complex(0, 1) * im.col(k);
    if (r.left.size() > 0) {
      r.left = re.col(at) + Complex(0, 1) * im.col(at);
      ++at;
    }
  }
}

// A double real root comes from rounding as two real roots or as a conjugate pair beside the axis, and its mirror image
// may come as the other. A pair to rounding, λ and λ̄ side by side, is made two real roots with the real and the
// imaginary part of the vector, which span the same.
struct PlainRoots {
  ComplexVector lambda;
  ComplexMatrix w;
};
std::optional<PlainRoots> with_double_roots_real(const ComplexVector& lambda, const ComplexMatrix& w) {
  const double rounding = 16 * static_cast<double>(lambda.size()) * epsilon * lambda.cwiseAbs().maxCoeff();
  std::optional<PlainRoots> changed;
  for (Index i = 0; i + 1 < lambda.size(); ++i) {
    const double im = std::abs(lambda(i).imag());
    if (im == 0 || im > rounding || std::abs(lambda(i).real()) <= 100 * rounding || lambda(i + 1) != std::conj(lambda(i))) continue;
    if (!changed) changed = PlainRoots{lambda, w};
    const Vector re = w.col(i).real().normalized(), part = w.col(i).imag(), across = part - re.dot(part) * re;
    if (!(across.norm() > 1e-6)) continue;
    changed->lambda(i) = changed->lambda(i + 1) = lambda(i).real();
    changed->w.col(i) = re.cast<Complex>();
    changed->w.col(i + 1) = across.normalized().cast<Complex>();
    ++i;
  }
  return changed;
}

// One level: `p` is `whole` on the span of `basis` (`whole` itself where that is empty), λ and w its plain eigenpairs.
// Roots far below the largest are taken again in a basis of their span, on which the whole pencil is projected, not
// this one: what is small in it keeps its digits.
std::vector<EvenRoot> roots_of(const EvenPencil& whole, const EvenPencil& p, const Matrix& basis, const ComplexVector& plain_lambda,
                               const ComplexMatrix& plain_w, int depth) {
  constexpr double small_ratio = 1e-3;  // down to here shapes have the residual of rounding, to several hundred ε
  constexpr int deepest = 12;
  if (plain_lambda.size() == 0) return {};
  const auto changed = with_double_roots_real(plain_lambda, plain_w);
  const ComplexVector& lambda = changed ? changed->lambda : plain_lambda;
  const ComplexMatrix& w = changed ? changed->w : plain_w;
  const double largest = lambda.cwiseAbs().maxCoeff();
  const double limit = depth < deepest ? gap_below(lambda, small_ratio * largest) : 0;
  std::vector<Index> small, real, upper;
  std::vector<EvenRoot> roots;
  for (Index i = 0; i < lambda.size(); ++i) {
    if (std::abs(lambda(i)) < limit) {
      small.push_back(i);
    } else if (lambda(i).imag() == 0) {
      real.push_back(i);
    } else if (lambda(i).imag() > 0) {
      upper.push_back(i);
    }
  }
  if (small.size() % 2 != 0) return roots_of(whole, p, basis, lambda, w, deepest);  // a pair torn by the limit: everything at this level
  for (const auto& [i, partner] : real_pairs(lambda, real)) roots.push_back({lambda(i), w.col(i), w.col(partner)});
  for (EvenRoot& r : roots_of_groups(p, lambda(upper), w(Eigen::all, upper))) roots.push_back(std::move(r));
  if (basis.size() > 0) expand(basis, roots);
  if (small.empty()) return roots;
  const Matrix part = real_basis(w, lambda, small);
  const Matrix v = basis.size() > 0 ? orthonormal_basis(lapack::multiply(basis, part)) : part;
  const EvenPencil inner = whole.projected(v);
  const auto e = inner.plain_eigen();
  for (EvenRoot& r : roots_of(whole, inner, v, e.values, e.vectors, depth + 1)) roots.push_back(std::move(r));
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
  if (!second_order_) return lapack::general_eigen(lapack::solve_general(s_, -e_));
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

std::vector<EvenRoot> roots_of(const EvenPencil& p, const ComplexVector& lambda, const ComplexMatrix& w) {
  return roots_of(p, p, Matrix(), lambda, w, 0);
}

}  // namespace gyromode::dense
