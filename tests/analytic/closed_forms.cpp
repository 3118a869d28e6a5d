#include "closed_forms.h"

#include <cmath>
#include <numbers>

namespace gyromode::analytic {

namespace {

Matrix kronecker(const Matrix& a, const Matrix& b) {
  Matrix c(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < a.rows(); ++i) {
    for (Index j = 0; j < a.cols(); ++j) c.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  }
  return c;
}

Matrix diagonal(std::initializer_list<double> d) {
  Matrix a = Matrix::Zero(static_cast<Index>(d.size()), static_cast<Index>(d.size()));
  Index i = 0;
  for (const double x : d) {
    a(i, i) = x;
    ++i;
  }
  return a;
}

}  // namespace

Matrix rotation_generator() {
  Matrix j(2, 2);
  j << 0, -1, 1, 0;
  return j;
}

System RotatingFrame::system() const {
  const Matrix one = Matrix::Identity(2, 2);
  return System(kronecker(one, mass), 2 * spin * kronecker(rotation_generator(), mass), kronecker(one, stiffness - spin * spin * mass));
}

System StabilisedPair::system() const { return System(Matrix::Identity(2, 2), g * rotation_generator(), diagonal({-k1, -k2})); }

std::vector<double> StabilisedPair::frequencies() const {
  const double b = g * g - k1 - k2;
  const double discriminant = b * b - 4 * k1 * k2;
  if (b <= 0 || discriminant < 0) return {};
  const double large = 0.5 * (b + std::sqrt(discriminant));
  return {std::sqrt(k1 * k2 / large), std::sqrt(large)};
}

System SpinningBody::system() const {
  return System(diagonal({i1, i2}), (i1 + i2 - i3) * spin * rotation_generator(), spin * spin * diagonal({i3 - i2, i3 - i1}));
}

double SpinningBody::nutation_squared() const { return spin * spin * (i3 - i1) * (i3 - i2) / (i1 * i2); }

System SpringMass::system() const {
  Matrix g = Matrix::Zero(3, 3);
  g.topLeftCorner(2, 2) = 2 * mass * spin * rotation_generator();
  return System(mass * Matrix::Identity(3, 3), g, diagonal({kx - mass * spin * spin, ky - mass * spin * spin, kz}));
}

FirstOrderSystem MeirovitchBody::system() const {
  const double whole = a_inertia + mass * arm * arm;
  Matrix inertia = diagonal({stiffness, stiffness, mass, mass, whole, whole});
  inertia(2, 5) = inertia(5, 2) = mass * arm;
  inertia(3, 4) = inertia(4, 3) = -mass * arm;
  Matrix g = Matrix::Zero(6, 6);
  g(0, 1) = -stiffness * spin;
  g(0, 2) = g(1, 3) = -stiffness;
  g(2, 3) = -mass * spin;
  g(2, 4) = g(3, 5) = mass * arm * spin;
  g(4, 5) = (c_inertia - whole) * spin;
  return FirstOrderSystem(inertia, g - g.transpose(), {"u1", "u2", "w1", "w2", "ω1", "ω2"});
}

System wiresaw(Index n, double speed) {
  Matrix k = Matrix::Zero(n, n);
  Matrix g = Matrix::Zero(n, n);
  for (Index i = 0; i < n; ++i) {
    const double j = static_cast<double>(i + 1);
    k(i, i) = j * j * std::numbers::pi * std::numbers::pi * (1 - speed * speed) / 2;
    for (Index l = 0; l < i; ++l) {
      const double m = static_cast<double>(l + 1);
      if ((i + l) % 2 == 0) continue;
      g(i, l) = 4 * j * m * speed / (j * j - m * m);
      g(l, i) = -g(i, l);
    }
  }
  return System(0.5 * Matrix::Identity(n, n), g, k);
}

}  // namespace gyromode::analytic
