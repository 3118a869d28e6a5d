#include "random_system.h"

#include "gyromode/lapack/small.h"
#include "gyromode/system/laws.h"

#include <cmath>

namespace gyromode::support {

namespace {

// SplitMix64 and its own uniform and normal draws: std distributions differ between libraries.
class Source {
 public:
  explicit Source(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ull + 1) {}

  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  double between(double a, double b) { return a + (b - a) * uniform(); }
  Index integer(Index a, Index b) { return a + static_cast<Index>(bits() % static_cast<std::uint64_t>(b - a + 1)); }
  bool chance(double p) { return uniform() < p; }
  double normal() { return std::sqrt(-2 * std::log(1 - uniform())) * std::cos(2 * 3.14159265358979323846 * uniform()); }

 private:
  std::uint64_t state_;
};

Matrix gaussian(Source& s, Index rows, Index cols) {
  Matrix a(rows, cols);
  for (Index j = 0; j < cols; ++j) {
    for (Index i = 0; i < rows; ++i) a(i, j) = s.normal();
  }
  return a;
}

Matrix integers(Source& s, Index rows, Index cols, Index most) {
  Matrix a(rows, cols);
  for (Index j = 0; j < cols; ++j) {
    for (Index i = 0; i < rows; ++i) a(i, j) = static_cast<double>(s.integer(-most, most));
  }
  return a;
}

Matrix orthogonal(Source& s, Index n) { return small::orthogonal_factor(gaussian(s, n, n)); }

// Eigenvalues of K (relative to M = 1): the shapes of spectrum that break solvers.
Vector spectrum(Source& s, Index n, std::string& description) {
  Vector d(n);
  const Index shape = s.integer(0, 4);
  for (Index i = 0; i < n; ++i) {
    if (shape == 0) d(i) = s.between(0.1, 10);                                               // generic
    if (shape == 1) d(i) = static_cast<double>(s.integer(1, 3)) * (1 + 1e-9 * s.uniform());  // clusters
    if (shape == 2) d(i) = std::pow(10.0, s.between(-6, 6));                                 // graded over 12 decades
    if (shape == 3) d(i) = 1 + std::floor(static_cast<double>(i) / 2);                       // exact pairs
    if (shape == 4) d(i) = 1;                                                                // all equal
  }
  static const char* const names[] = {"generic", "clustered", "graded", "pairs", "equal"};
  description += std::string(", ") + names[shape];
  return d;
}

void apply_signs(Source& s, Vector& d, std::string& description) {
  const Index kind = s.integer(0, 5);
  if (kind <= 1) {
    description += ", K>0";
  } else if (kind == 2) {
    d = -d;
    description += ", K<0";
  } else {
    for (Index i = 0; i < d.size(); ++i) d(i) = s.chance(0.5) ? -d(i) : d(i);
    description += ", K indefinite";
  }
}

// Zero pattern of the quadrature class with p coordinates in the first group.
void keep_partition(Matrix& m, Matrix& g, Matrix& k, Index p) {
  const Index r = m.rows() - p;
  m.topRightCorner(p, r).setZero();
  m.bottomLeftCorner(r, p).setZero();
  k.topRightCorner(p, r).setZero();
  k.bottomLeftCorner(r, p).setZero();
  g.topLeftCorner(p, p).setZero();
  g.bottomRightCorner(r, r).setZero();
}

// Real matrices with prescribed spectra of K, by orthogonal similarity and a congruence of modest condition.
RandomSystem prescribed(Source& s, Index n) {
  RandomSystem r;
  const bool quadrature = n == 1 || s.chance(0.5);
  const Index p = quadrature ? s.integer(1, std::max<Index>(1, n - 1)) : n;
  r.description = quadrature ? "quadrature" : "general";
  Vector d = spectrum(s, n, r.description);
  apply_signs(s, d, r.description);
  const Index groups[2] = {p, n - p};
  r.mass = Matrix::Zero(n, n);
  r.stiffness = Matrix::Zero(n, n);
  Index at = 0;
  for (const Index size : groups) {
    if (size == 0) continue;
    const Matrix q = orthogonal(s, size);
    const Matrix c = Matrix::Identity(size, size) + 0.3 * gaussian(s, size, size) / std::sqrt(static_cast<double>(size));
    const Matrix root = q * c;
    r.stiffness.block(at, at, size, size) = symmetric_part(root * d.segment(at, size).asDiagonal() * root.transpose());
    r.mass.block(at, at, size, size) = symmetric_part(root * root.transpose() + 0.05 * Matrix::Identity(size, size));
    at += size;
  }
  r.gyroscopic = skew_part(gaussian(s, n, n)) * std::pow(10.0, s.between(-3, 2)) * std::sqrt(d.cwiseAbs().mean());
  if (s.chance(0.05)) r.gyroscopic.setZero();
  if (quadrature) keep_partition(r.mass, r.gyroscopic, r.stiffness, p);
  return r;
}

// Small integers: singular K, zero roots and multiple roots are exact.
RandomSystem integral(Source& s, Index n) {
  RandomSystem r;
  const bool quadrature = n == 1 || s.chance(0.5);
  const Index p = quadrature ? s.integer(1, std::max<Index>(1, n - 1)) : n;
  r.description = std::string(quadrature ? "quadrature" : "general") + ", integers";
  const Matrix a = integers(s, n, n, 2);
  r.mass = a * a.transpose() + Matrix::Identity(n, n) * static_cast<double>(s.integer(1, 3));
  Matrix b = integers(s, n, n, 2);
  Vector d(n);
  const bool semidefinite = s.chance(0.5);
  for (Index i = 0; i < n; ++i) d(i) = static_cast<double>(s.integer(semidefinite ? 0 : -1, 1));
  if (quadrature) keep_partition(r.mass, b, b, p);  // b block diagonal is not needed: K is cut below
  b = integers(s, n, n, 2);
  if (quadrature) {
    b.topRightCorner(p, n - p).setZero();
    b.bottomLeftCorner(n - p, p).setZero();
  }
  r.stiffness = b * d.asDiagonal() * b.transpose();
  r.gyroscopic = integers(s, n, n, 3);
  r.gyroscopic = (r.gyroscopic - r.gyroscopic.transpose()).eval();
  if (quadrature) keep_partition(r.mass, r.gyroscopic, r.stiffness, p);
  return r;
}

// Rotating axes: closed-form whirl pairs, K of any sign, sometimes Ω exactly at a frequency (integers).
RandomSystem whirling(Source& s, Index n) {
  const Index h = std::max<Index>(1, n / 2);
  RandomSystem r;
  r.description = "rotating frame";
  Vector w(h);
  for (Index i = 0; i < h; ++i) w(i) = static_cast<double>(s.integer(1, 6));
  const double spin = s.chance(0.5) ? static_cast<double>(s.integer(0, 7)) : s.between(0, 7);
  r.mass = Matrix::Identity(2 * h, 2 * h);
  r.stiffness = Matrix::Zero(2 * h, 2 * h);
  r.gyroscopic = Matrix::Zero(2 * h, 2 * h);
  for (Index i = 0; i < h; ++i) {
    r.stiffness(i, i) = r.stiffness(h + i, h + i) = w(i) * w(i) - spin * spin;
    r.gyroscopic(i, h + i) = -2 * spin;
    r.gyroscopic(h + i, i) = 2 * spin;
  }
  if (s.chance(0.7)) {  // couple what is not coupled
    const Matrix q = orthogonal(s, h);
    Matrix t = Matrix::Zero(2 * h, 2 * h);
    t.topLeftCorner(h, h) = t.bottomRightCorner(h, h) = q;
    const bool whole = s.chance(0.5);
    if (whole) t = orthogonal(s, 2 * h);
    r.stiffness = symmetric_part(t * r.stiffness * t.transpose());
    r.gyroscopic = skew_part(t * r.gyroscopic * t.transpose());
    r.description += whole ? ", scrambled" : ", mixed";
  }
  return r;
}

// Stabilised pairs at, or a little off, their threshold g = √k₁ + √k₂; exactly defective for exact squares.
RandomSystem at_threshold(Source& s, Index n) {
  const Index pairs = std::max<Index>(1, n / 2);
  RandomSystem r;
  r.description = "stabilisation threshold";
  r.mass = Matrix::Identity(2 * pairs, 2 * pairs);
  r.stiffness = Matrix::Zero(2 * pairs, 2 * pairs);
  r.gyroscopic = Matrix::Zero(2 * pairs, 2 * pairs);
  for (Index i = 0; i < pairs; ++i) {
    const double a = static_cast<double>(s.integer(1, 5));
    const double b = static_cast<double>(s.integer(1, 5));
    const double offset = s.chance(0.3) ? 0 : (s.chance(0.5) ? 1 : -1) * std::pow(10.0, s.between(-12, 0));
    r.stiffness(2 * i, 2 * i) = -a * a;
    r.stiffness(2 * i + 1, 2 * i + 1) = -b * b;
    r.gyroscopic(2 * i, 2 * i + 1) = -(a + b + offset);
    r.gyroscopic(2 * i + 1, 2 * i) = a + b + offset;
  }
  if (s.chance(0.4)) {
    const Matrix t = orthogonal(s, 2 * pairs);
    r.stiffness = symmetric_part(t * r.stiffness * t.transpose());
    r.gyroscopic = skew_part(t * r.gyroscopic * t.transpose());
    r.description += ", scrambled";
  }
  return r;
}

void permute(Source& s, RandomSystem& r) {
  const Index n = r.mass.rows();
  std::vector<Index> order(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) order[static_cast<std::size_t>(i)] = i;
  for (Index i = n - 1; i > 0; --i) std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(s.integer(0, i))]);
  r.mass = Matrix(r.mass(order, order));
  r.gyroscopic = Matrix(r.gyroscopic(order, order));
  r.stiffness = Matrix(r.stiffness(order, order));
}

}  // namespace

RandomSystem random_system(std::uint64_t seed) {
  Source s(seed);
  const Index n = s.integer(1, 12);
  const double pick = s.uniform();
  RandomSystem r = pick < 0.5 ? prescribed(s, n) : pick < 0.75 ? integral(s, n) : pick < 0.88 ? whirling(s, n) : at_threshold(s, n);
  permute(s, r);
  static const double scales[] = {0x1p-30, 1, 1, 0x1p30};  // powers of two: what is exact stays exact
  const double unit = scales[s.integer(0, 3)];
  if (unit != 1) {
    r.mass *= unit;
    r.gyroscopic *= unit;
    r.stiffness *= unit;
  }
  r.description += ", n = " + std::to_string(r.mass.rows()) + ", seed " + std::to_string(seed);
  return r;
}

}  // namespace gyromode::support
