#include "support/scrambled.h"

#include "support/random_matrices.h"

#include <algorithm>
#include <cmath>

namespace gyromode::support {

namespace {

struct Matrices {
  Matrix m, g, k;

  explicit Matrices(Index n) : m(Matrix::Identity(n, n)), g(Matrix::Zero(n, n)), k(Matrix::Zero(n, n)) {}
  void couple(const Matrix& b) {
    g.topRightCorner(b.rows(), b.cols()) = b;
    g.bottomLeftCorner(b.cols(), b.rows()) = -b.transpose();
  }
  void hold(const Matrix& k1, const Matrix& k2) {
    k.topLeftCorner(k1.rows(), k1.rows()) = k1;
    k.bottomRightCorner(k2.rows(), k2.rows()) = k2;
  }
};

Matrices generic(Source& s, Index p, Index r, double strength) {
  Matrices a(p + r);
  a.hold(s.symmetric(p, 0), s.symmetric(r, 0));
  a.couple(strength * s.gaussian(p, r));
  return a;
}

Matrices axisymmetric(Source& s, Index p) {
  Matrices a(2 * p);
  const Matrix m0 = s.symmetric(p, 0), k0 = s.symmetric(p, s.integer(0, 1) * p / 3), g0 = s.symmetric(p, 0);
  a.m.topLeftCorner(p, p) = a.m.bottomRightCorner(p, p) = m0;
  a.hold(k0, k0);
  a.couple(g0);
  return a;
}

Matrices repeated(Source& s, Index p, Index r) {
  Matrices a(p + r);
  for (double& x : a.k.diagonal()) x = static_cast<double>(s.integer(1, std::max<Index>(2, (p + r) / 3)));
  a.couple(s.gaussian(p, r));
  return a;
}

Matrices copies(Source& s, Index order) {
  const Index n = std::max<Index>(2, order / 4), count = order / n, p = s.integer(1, n - 1);
  const Matrices one = generic(s, p, n - p, 1);
  Matrices a(n * count);
  for (Index c = 0; c < count; ++c) {
    a.k.block(c * n, c * n, n, n) = one.k;
    a.g.block(c * n, c * n, n, n) = one.g;
  }
  return a;
}

Matrices sparse(Source& s, Index p, Index r) {
  Matrices a(p + r);
  a.hold(s.symmetric(p, s.integer(0, p)), s.symmetric(r, s.integer(0, r)));
  Matrix b = s.gaussian(p, r);
  for (double& x : b.reshaped()) x = s.integer(0, 9) < 7 ? 0 : x;
  b(0, 0) = 1;
  a.couple(b);
  return a;
}

// U diag(d) Vᵀ with d between 1 and 1/condition, both taken.
Matrix change_of_coordinates(Source& s, Index n, double condition) {
  std::uniform_real_distribution<double> uniform(0, 1);
  Vector d(n);
  for (double& x : d) x = std::pow(condition, -uniform(s.bits));
  d(0) = 1;
  d(n - 1) = 1 / condition;
  return s.orthogonal(n) * d.asDiagonal() * s.orthogonal(n).transpose();
}

}  // namespace

Scrambled scrambled_system(std::uint64_t seed, Index order, double most) {
  Source s{std::mt19937_64(seed)};
  const Index n = s.integer(4, order), p = s.integer(1, n - 1), kind = s.integer(0, 5);
  const auto made = [&] {
    switch (kind) {
      case 1: return axisymmetric(s, n / 2);
      case 2: return repeated(s, p, n - p);
      case 3: return copies(s, n);
      case 4: return sparse(s, p, n - p);
      case 5: return generic(s, p, n - p, 1e-3);
      default: return generic(s, p, n - p, 1);
    }
  };
  const Matrices a = made();
  const double condition = std::pow(most, std::uniform_real_distribution<double>(0, 1)(s.bits));
  const Matrix t = change_of_coordinates(s, a.m.rows(), condition);
  const auto changed = [&](const Matrix& x) { return Matrix(t.transpose() * x * t); };
  constexpr const char* names[] = {"generic", "axisymmetric", "repeated eigenvalues", "copies", "sparse", "weak G"};
  return {System(a.m, a.g, a.k), System(symmetric_part(changed(a.m)), skew_part(changed(a.g)), symmetric_part(changed(a.k))), condition,
          kind >= 1 && kind <= 3, std::string(names[kind]) + ", n " + std::to_string(a.m.rows())};
}

System with_perturbed_gyroscopic(const System& s, double size, std::uint64_t seed) {
  Source source{std::mt19937_64(seed)};
  const Matrix e = source.skew(s.size());
  return System(s.mass(), skew_part(s.gyroscopic() + size * s.gyroscopic().norm() / e.norm() * e), s.stiffness());
}

}  // namespace gyromode::support
