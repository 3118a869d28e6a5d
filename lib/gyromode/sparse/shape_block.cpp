#include "gyromode/sparse/shape_block.h"

#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/rounding_sizes.h"

#include "gyromode/lapack/multiply.h"

#include <algorithm>
#include <cmath>

namespace gyromode::sparse {

namespace {

// With a partition X = T u, T = diag(1, −j), and HX = T H*u with H* = K + ωC − ω²M, all real; without one u is X and C
// is jG. Columns of shapes and what the matrices make of them.
template <class Scalar>
struct Made {
  using Block = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  Block u, k, m, c;
};

Matrix product(const Matrix& a, const Matrix& b) { return lapack::multiply(a, b); }
ComplexMatrix product(const ComplexMatrix& a, const ComplexMatrix& b) { return lapack::multiply_complex(a, b); }
Matrix adjoint_product(const Matrix& a, const Matrix& b) { return lapack::multiply_tn(a, b); }
ComplexMatrix adjoint_product(const ComplexMatrix& a, const ComplexMatrix& b) { return lapack::multiply_adjoint(a, b); }

Made<double> made_of(const SparseSystem& s, const Groups& groups, const ShapeBlock& x) {
  Made<double> made;
  made.u = x.re - x.im;
  made.k = symmetric_times(s.stiffness(), made.u);
  made.m = symmetric_times(s.mass(), made.u);
  made.c = symmetric_times(coupling_of(s, groups), made.u);
  return made;
}

Made<Complex> made_of(const SparseSystem& s, const ShapeBlock& x) {
  const Complex j(0, 1);
  const auto joined = [&](const Matrix& re, const Matrix& im) { return ComplexMatrix(re + j * im); };
  return {joined(x.re, x.im), joined(symmetric_times(s.stiffness(), x.re), symmetric_times(s.stiffness(), x.im)),
          joined(symmetric_times(s.mass(), x.re), symmetric_times(s.mass(), x.im)),
          joined(-skew_times(s.gyroscopic(), x.im), skew_times(s.gyroscopic(), x.re))};
}

// uᴴKu, uᴴMu, uᴴCu of every column.
struct Forms {
  Vector k, m, c;
  double at(Index i, double w) const { return k(i) + w * c(i) - w * w * m(i); }
};

// Re Σ conj(a_i) b_i in short pieces, what is lost where they are added kept beside: of 10⁵ terms added one after the
// other rounding is 100 ε of the sum of moduli, and the root would be no better.
template <class Scalar>
double sum_of_products(const Scalar* a, const Scalar* b, Index n) {
  using Piece = Eigen::Map<const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>>;
  constexpr Index piece = 64;
  double sum = 0, lost = 0;
  for (Index i = 0; i < n; i += piece) {
    const Index m = std::min(piece, n - i);
    const double term = std::real(Piece(a + i, m).dot(Piece(b + i, m))), next = sum + term;
    lost += std::abs(sum) >= std::abs(term) ? (sum - next) + term : (term - next) + sum;
    sum = next;
  }
  return sum + lost;
}

template <class Scalar>
Forms forms_of(const Made<Scalar>& a) {
  const auto form = [&](const auto& b) {
    Vector f(b.cols());
    for (Index k = 0; k < b.cols(); ++k) f(k) = sum_of_products(a.u.col(k).data(), b.col(k).data(), b.rows());
    return f;
  };
  return {form(a.k), form(a.m), form(a.c)};
}

double root_next_to(double omega, double k, double c, double m) {
  const double middle = c / (2 * m), square = middle * middle + k / m;
  if (!(square >= 0)) return omega;
  const double off = std::sqrt(square);
  return std::abs(middle + off - omega) < std::abs(middle - off - omega) ? middle + off : middle - off;
}

Vector roots_of(const Forms& f, const Vector& near) {
  Vector w(near.size());
  for (Index k = 0; k < w.size(); ++k) w(k) = root_next_to(near(k), f.k(k), f.c(k), f.m(k));
  return w;
}

template <class Block>
Block impedance_times(const Block& k, const Block& c, const Block& m, const Vector& w) {
  const Vector square = w.cwiseAbs2();
  return k + c * w.asDiagonal() - m * square.asDiagonal();
}

// Shapes have parts of each other, by rounding of the inner product they were found in: u_k loses
// u_iᴴH(ω_k)u_k / u_iᴴH(ω_k)u_i of u_i, to first order, again and again, in the space that they span. Of roots that are
// one to rounding any combination serves.
template <class Scalar>
void separate(Made<Scalar>& a, const Vector& near) {
  using Block = typename Made<Scalar>::Block;
  Block k = adjoint_product(a.u, a.k), c = adjoint_product(a.u, a.c), m = adjoint_product(a.u, a.m),
        all = Block::Identity(k.rows(), k.cols());
  constexpr int most = 6;
  constexpr double largest = 0.1, settled = 1e-14;
  for (int round = 0; round < most; ++round) {
    const Forms f{k.diagonal().real(), m.diagonal().real(), c.diagonal().real()};
    const Vector w = roots_of(f, near);
    const Block s = impedance_times(k, c, m, w);
    Block change = Block::Identity(s.rows(), s.cols());
    double moved = 0;
    for (Index q = 0; q < s.cols(); ++q) {
      for (Index i = 0; i < s.rows(); ++i) {
        const Scalar part = s(i, q) / f.at(i, w(q));
        const double size = std::abs(part) * std::sqrt(std::abs(f.m(i) / f.m(q)));
        if (i == q || !(size <= largest)) continue;
        change(i, q) = -part;
        moved = std::max(moved, size);
      }
    }
    all = all * change;
    for (Block* b : {&k, &c, &m}) *b = change.adjoint() * *b * change;
    if (moved <= settled) break;
  }
  for (Block* b : {&a.u, &a.k, &a.m, &a.c}) *b = product(*b, all);
}

template <class Scalar>
std::vector<RitzMode> modes_of(const SparseSystem& s, const Groups& groups, const Norms& norms, Made<Scalar> a, Vector near,
                               const Vector& all) {
  separate(a, near);
  const Forms f = forms_of(a);
  const Vector w = roots_of(f, near);
  const auto r = impedance_times(a.k, a.c, a.m, w);
  const Vector inverse_mass = s.mass().diagonal().cwiseInverse();
  const RoundingSizes sizes(s);
  std::vector<RitzMode> modes;
  for (Index k = 0; k < w.size(); ++k) {
    RitzMode mode;
    mode.omega = w(k);
    mode.form = 2 * w(k) * f.m(k) - f.c(k);
    mode.energy_sign = mode.form < 0 ? -1 : 1;
    mode.shape = a.u.col(k).template cast<Complex>();
    if (groups.partition) {
      for (const Index i : groups.rows[1]) mode.shape(i) *= Complex(0, -1);
    }
    mode.residual = r.col(k).norm() / ((norms.k + w(k) * norms.g + w(k) * w(k) * norms.m) * mode.shape.norm());
    const double rho = std::sqrt(r.col(k).cwiseAbs2().dot(inverse_mass) * f.m(k)) / std::abs(mode.form);
    mode.error_bound = error_of(rho, w(k), all) + sizes.of(mode.shape, w(k)) / std::abs(mode.form);
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace

std::vector<RitzMode> measured(const SparseSystem& s, const Groups& groups, const Norms& norms, const ShapeBlock& shapes,
                               const Vector& all) {
  return groups.partition ? modes_of(s, groups, norms, made_of(s, groups, shapes), shapes.omega, all)
                          : modes_of(s, groups, norms, made_of(s, shapes), shapes.omega, all);
}

}  // namespace gyromode::sparse
