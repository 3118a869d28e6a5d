#include "campaign/hostile_system.h"

#include "support/random_matrices.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode::support {

namespace {

using Matrices = HostileSystem::Matrices;

struct Draw : Source {
  explicit Draw(std::uint64_t seed) { bits.seed(seed * 0x9E3779B97F4A7C15ull + 4); }
  bool chance(double p) { return std::uniform_real_distribution<double>(0, 1)(bits) < p; }
  double power_of_two(Index low, Index high) { return std::ldexp(1.0, static_cast<int>(integer(low, high))); }
  Matrix skew_integers(Index n, Index most) {
    Matrix g = Matrix::Zero(n, n);
    for (Index i = 0; i < n; ++i) {
      for (Index k = 0; k < i; ++k) {
        g(i, k) = static_cast<double>(integer(-most, most));
        g(k, i) = -g(i, k);
      }
    }
    return g;
  }
  Matrix symmetric_integers(Index n, Index most) {
    Matrix k = integers(n, n, most);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < i; ++j) k(i, j) = k(j, i);
    }
    return k;
  }
};

// A product of elementary row operations: integer, determinant 1, entries kept small.
Matrix unimodular(Draw& d, Index n, Index operations) {
  Matrix u = Matrix::Identity(n, n);
  for (Index step = 0; step < operations && n > 1; ++step) {
    const Index i = d.integer(0, n - 1);
    const Index k = (i + d.integer(1, n - 1)) % n;
    const Matrix before = u;
    u.row(i) += (d.chance(0.5) ? 1 : -1) * u.row(k);
    if (u.cwiseAbs().maxCoeff() > 4) u = before;
  }
  return u;
}

Matrices congruent(const Matrices& m, const Matrix& u) {
  return {u.transpose() * m.mass * u, u.transpose() * m.gyroscopic * u, u.transpose() * m.stiffness * u};
}

Matrix mass(Draw& d, Index n) {
  if (d.chance(0.6)) return Matrix::Identity(n, n);
  const Matrix a = d.integers(n, n, 1);
  return a * a.transpose() + Matrix::Identity(n, n) * static_cast<double>(d.integer(1, 2));
}

Matrices generic(Draw& d, Index n, std::string& what) {
  Matrices m{mass(d, n), d.skew_integers(n, 3), d.symmetric_integers(n, 4)};
  const Index kind = d.integer(0, 4);
  if (kind == 1) {  // exactly singular, of any sign
    const Matrix b = d.integers(n, n, 2);
    Vector s(n);
    for (double& x : s) x = static_cast<double>(d.integer(-1, 1));
    m.stiffness = b * s.asDiagonal() * b.transpose();
    what += ", singular";
  } else if (kind == 2) {  // K > 0
    m.stiffness = m.stiffness * m.stiffness.transpose() + Matrix::Identity(n, n);
  } else if (kind == 3) {  // few couplings, rows of zeros
    for (double& x : m.stiffness.reshaped()) x = 0;
    for (Index i = 0; i < n; ++i) m.stiffness(i, i) = static_cast<double>(d.integer(-3, 4));
    what += ", diagonal";
  }
  if (d.chance(0.3)) {  // G of low rank
    const Matrix a = d.integers(n, 1, 2), b = d.integers(n, 1, 2);
    m.gyroscopic = a * b.transpose() - b * a.transpose();
    what += ", rank(G) 2";
  }
  if (d.chance(0.25) && n > 1) {  // a partition
    const Index p = d.integer(1, n - 1);
    for (Index i = 0; i < n; ++i) {
      for (Index k = 0; k < n; ++k) {
        const bool across = (i < p) != (k < p);
        if (across)
          m.mass(i, k) = m.stiffness(i, k) = 0;
        else
          m.gyroscopic(i, k) = 0;
      }
    }
    what += ", quadrature";
  }
  return m;
}

// Masses on springs in axes that turn with the integer spin Ω: K = K₀ − Ω², a double defective root at Ω for every free
// translation.
Matrices turning_frame(Draw& d, Index n, std::string& what) {
  const Index h = std::max<Index>(1, n / 2);
  const double spin = static_cast<double>(d.integer(1, 4));
  Matrix k0 = Matrix::Zero(2 * h, 2 * h);
  const Index springs = d.integer(0, 2 * h);
  for (Index s = 0; s < springs; ++s) {  // along a line of integer slope, between two masses or to ground
    const Index a = d.integer(0, h - 1), b = d.integer(0, h - 1);
    Vector along = Vector::Zero(2 * h);
    const double x = static_cast<double>(d.integer(-1, 1)), y = static_cast<double>(d.integer(0, 1));
    along(a) += x;
    along(h + a) += y;
    if (a != b) {
      along(b) -= x;
      along(h + b) -= y;
    }
    k0 += static_cast<double>(d.integer(1, 9)) * along * along.transpose();
  }
  Matrices m{Matrix::Identity(2 * h, 2 * h), Matrix::Zero(2 * h, 2 * h), k0 - spin * spin * Matrix::Identity(2 * h, 2 * h)};
  m.gyroscopic.topRightCorner(h, h).diagonal().setConstant(-2 * spin);
  m.gyroscopic.bottomLeftCorner(h, h).diagonal().setConstant(2 * spin);
  what += ", turning frame";
  return m;
}

// Pairs k = (−a², −b²), g = a + b (+ a step of 1): exactly defective, or on either side.
Matrices thresholds(Draw& d, Index n, std::string& what) {
  const Index pairs = std::max<Index>(1, n / 2);
  Matrices m{Matrix::Identity(2 * pairs, 2 * pairs), Matrix::Zero(2 * pairs, 2 * pairs), Matrix::Zero(2 * pairs, 2 * pairs)};
  for (Index i = 0; i < pairs; ++i) {
    const double a = static_cast<double>(d.integer(1, 5)), b = static_cast<double>(d.integer(1, 5));
    const double g = a + b + static_cast<double>(d.integer(-1, 1));
    m.stiffness(2 * i, 2 * i) = -a * a;
    m.stiffness(2 * i + 1, 2 * i + 1) = -b * b;
    m.gyroscopic(2 * i, 2 * i + 1) = -g;
    m.gyroscopic(2 * i + 1, 2 * i) = g;
  }
  what += ", thresholds";
  return m;
}

Matrices copies(const Matrices& one, Index count) {
  const Index n = one.mass.rows();
  Matrices m{Matrix::Zero(n * count, n * count), Matrix::Zero(n * count, n * count), Matrix::Zero(n * count, n * count)};
  for (Index c = 0; c < count; ++c) {
    m.mass.block(c * n, c * n, n, n) = one.mass;
    m.gyroscopic.block(c * n, c * n, n, n) = one.gyroscopic;
    m.stiffness.block(c * n, c * n, n, n) = one.stiffness;
  }
  return m;
}

}  // namespace

HostileSystem hostile_system(std::uint64_t seed) {
  Draw d(seed);
  HostileSystem h;
  h.description = fmt::format("seed {}", seed);
  Index n = d.integer(1, 12);
  const Index family = d.integer(0, 9);
  Matrices m;
  if (family <= 6) m = generic(d, n, h.description);
  if (family == 7) m = turning_frame(d, n, h.description);
  if (family == 8) m = thresholds(d, n, h.description);
  if (family == 9) {
    n = d.integer(1, 4);
    m = copies(generic(d, n, h.description), d.integer(2, 12 / n));
    h.description += ", copies";
  }
  n = m.mass.rows();
  if (family >= 7 && d.chance(0.7)) m = congruent(m, unimodular(d, n, d.integer(1, 3 * n)));
  const Index regime = d.integer(0, 5);
  if (regime >= 4) {  // strong spin
    const double spin = d.power_of_two(0, 30);
    m.gyroscopic *= spin;
    h.description += fmt::format(", G x {:g}", spin);
  }
  if (regime == 2 || regime == 5) {  // graded stiffness, sometimes with G in the same grading
    Vector grade(n);
    const Index most = d.integer(1, 27);
    for (double& x : grade) x = d.power_of_two(0, most);
    m.stiffness = grade.asDiagonal() * m.stiffness * grade.asDiagonal();
    if (d.chance(0.3)) {  // G follows: 2^⌈(a_i + a_k)/2⌉ on entry (i, k)
      for (Index i = 0; i < n; ++i) {
        for (Index k = 0; k < n; ++k) m.gyroscopic(i, k) *= std::exp2(std::ceil(0.5 * std::log2(grade(i) * grade(k))));
      }
    }
    h.description += fmt::format(", graded 2^{}", 2 * most);
  }
  h.base = m;
  h.given = m;
  if (d.chance(0.4)) {
    Vector unit(n);
    for (double& x : unit) x = d.power_of_two(-30, 30);
    h.given = {unit.asDiagonal() * m.mass * unit.asDiagonal(), unit.asDiagonal() * m.gyroscopic * unit.asDiagonal(),
               unit.asDiagonal() * m.stiffness * unit.asDiagonal()};
    h.description += ", mixed units";
  }
  if (d.chance(0.4)) {
    h.time_unit = d.power_of_two(-30, 30);
    h.given.gyroscopic *= h.time_unit;
    h.given.stiffness *= h.time_unit * h.time_unit;
    h.description += fmt::format(", time x {:g}", h.time_unit);
  }
  h.description += fmt::format(", n = {}", n);
  return h;
}

}  // namespace gyromode::support
