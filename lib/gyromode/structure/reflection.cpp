#include "gyromode/structure/reflection.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/laws.h"

#include <cmath>
#include <utility>

namespace gyromode {

namespace {

using lapack::multiply;
using lapack::multiply_nt;
using lapack::multiply_tn;

// The three conditions as one vector, each over its unit.
struct Conditions {
  Matrix k12, gamma1, gamma2;

  double squared() const { return 2 * k12.squaredNorm() + gamma1.squaredNorm() + gamma2.squaredNorm(); }
};

class Linearised {
 public:
  Linearised(const Reflection& r, double unit_k, double unit_gamma) : k1_(r.k1 / unit_k), k2_(r.k2 / unit_k), b_(r.b / unit_gamma) {}

  Conditions at(const Matrix& theta) const {
    const Matrix first = multiply_nt(theta, b_), second = multiply_tn(b_, theta);
    return {multiply(k1_, theta) - multiply(theta, k2_), first - first.transpose(), second.transpose() - second};
  }
  // The transpose in the inner product of squared().
  Matrix back(const Conditions& c) const {
    return 2 * (multiply(k1_, c.k12) - multiply(c.k12, k2_)) + 2 * multiply(c.gamma1, b_) - 2 * multiply(b_, c.gamma2);
  }

 private:
  Matrix k1_, k2_, b_;
};

// Conjugate gradients until the gradient is small, or the residual: below a tenth of `small` it need not become less
// where a step takes little off it.
Matrix least_squares(const Linearised& a, Conditions residual, double small) {
  constexpr int steps = 80;
  constexpr double enough = 1e-4;  // of the gradient: the next turn goes on from there
  Matrix gradient = a.back(residual);
  Matrix theta = Matrix::Zero(gradient.rows(), gradient.cols());
  Matrix direction = gradient;
  double length = gradient.squaredNorm();
  const double first = length;
  double left = residual.squared();
  for (int step = 0; step < steps && length > enough * enough * first && length > 0; ++step) {
    const Conditions image = a.at(direction);
    const double size = image.squared();
    if (!(size > 0)) break;
    const double alpha = length / size;
    theta += alpha * direction;
    residual.k12 -= alpha * image.k12;
    residual.gamma1 -= alpha * image.gamma1;
    residual.gamma2 -= alpha * image.gamma2;
    const double before = std::exchange(left, residual.squared());
    if (left < 1e-2 * small * small && left > 0.8 * before) break;
    gradient = a.back(residual);
    const double next = gradient.squaredNorm();
    direction = gradient + (next / length) * direction;
    length = next;
  }
  return theta;
}

}  // namespace

Reflection::Reflection(const Matrix& k, const Matrix& gamma, Matrix plus_, Matrix minus_)
    : plus(std::move(plus_)), minus(std::move(minus_)) {
  const Matrix k_plus = multiply(k, plus), gamma_plus = multiply(gamma, plus);
  k1 = symmetric_part(multiply_tn(plus, k_plus));
  k2 = symmetric_part(multiply_tn(minus, multiply(k, minus)));
  k12 = multiply_tn(k_plus, minus);
  b = -multiply_tn(gamma_plus, minus);
  gamma1 = skew_part(multiply_tn(plus, gamma_plus));
  gamma2 = skew_part(multiply_tn(minus, multiply(gamma, minus)));
}

double Reflection::departure_k() const { return std::sqrt(2.0) * k12.norm(); }
double Reflection::departure_gamma() const { return std::hypot(gamma1.norm(), gamma2.norm()); }

SignedBasis sign_of(const Matrix& x) {
  const auto e = lapack::symmetric_eigen(x);
  const Index r = (e.values.array() < 0).count();
  const Vector size = e.values.cwiseAbs();
  const double largest = size.maxCoeff();
  return {e.vectors.rightCols(x.rows() - r), e.vectors.leftCols(r), largest > 0 ? size.minCoeff() / largest : 0};
}

SignedBasis commuting_with(const Matrix& k, const Reflection& r, double noise) {
  const auto e = lapack::symmetric_eigen(k);
  const Matrix plus = multiply_tn(e.vectors, r.plus);
  Matrix t = 2 * multiply_nt(plus, plus);
  t.diagonal().array() -= 1;
  for (Index j = 0; j < t.cols(); ++j) {
    for (Index i = 0; i < t.rows(); ++i) {
      if (std::abs(e.values(i) - e.values(j)) > noise) t(i, j) = 0;
    }
  }
  SignedBasis signs = sign_of(t);
  signs.plus = multiply(e.vectors, signs.plus);
  signs.minus = multiply(e.vectors, signs.minus);
  return signs;
}

Reflection turned(const Matrix& k, const Matrix& gamma, Reflection r, double unit_k, double unit_gamma, double enough) {
  constexpr int turns = 8;
  const auto size = [&](const Reflection& s) { return std::hypot(s.departure_k() / unit_k, s.departure_gamma() / unit_gamma); };
  for (int turn = 0; turn < turns && size(r) > enough; ++turn) {
    const Matrix theta =
        least_squares(Linearised(r, unit_k, unit_gamma), {-r.k12 / unit_k, -r.gamma1 / unit_gamma, -r.gamma2 / unit_gamma}, enough);
    Reflection next(k, gamma, lapack::orthonormal_columns(r.plus - multiply_nt(r.minus, theta)),
                    lapack::orthonormal_columns(r.minus + multiply(r.plus, theta)));
    const double gain = size(next) / size(r);
    if (!(gain < 1)) break;
    r = std::move(next);
    if (gain > 0.9) break;
  }
  return r;
}

}  // namespace gyromode
