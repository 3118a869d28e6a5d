#include "gyromode/structure/conjugation.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"
#include "gyromode/structure/phases.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// UᵀU, complex symmetric, by real products.
ComplexMatrix self_product(const ComplexMatrix& u) {
  const Matrix re = u.real(), im = u.imag();
  const Matrix cross = lapack::multiply_tn(re, im);
  ComplexMatrix w(u.cols(), u.cols());
  w.real() = lapack::gram(re) - lapack::gram(im);
  w.imag() = cross + cross.transpose();
  return w;
}

}  // namespace

std::vector<Cluster> clusters_of(const Vector& ascending, double width) {
  std::vector<Cluster> clusters;
  for (Index i = 0; i < ascending.size(); ++i) {
    if (i > 0 && ascending(i) - ascending(i - 1) <= width)
      ++clusters.back().count;
    else
      clusters.push_back({i, 1});
  }
  return clusters;
}

Conjugation::Conjugation(ComplexMatrix u, std::vector<Cluster> clusters)
    : u_(std::move(u)), clusters_(std::move(clusters)), w_(self_product(u_)) {
  for (const Cluster& c : clusters_) {
    for (Index j = c.first; j < c.first + c.count; ++j) {
      for (Index i = c.first; i <= j; ++i) unknowns_.push_back({i, j});
    }
  }
}

Vector Conjugation::applied(const Vector& x) const {
  const Index m = size();
  const double half = std::sqrt(0.5);
  ComplexMatrix z = ComplexMatrix::Zero(w_.rows(), w_.cols());  // (W D̄)ᵀ, by columns of its transpose: W is symmetric
  for (Index v = 0; v < m; ++v) {
    const auto [i, j] = unknowns_[static_cast<std::size_t>(v)];
    const Complex d = Complex(x(v), -x(m + v)) * (i == j ? 1.0 : half);
    z.col(j) += d * w_.col(i);
    if (i != j) z.col(i) += d * w_.col(j);
  }
  z.transposeInPlace();
  Vector y(2 * m);
  for (Index v = 0; v < m; ++v) {
    const auto [i, j] = unknowns_[static_cast<std::size_t>(v)];
    Complex d = z.col(i).conjugate().dot(w_.col(j));
    if (i != j) d /= half;
    y(v) = d.real();
    y(m + v) = d.imag();
  }
  return y;
}

ComplexMatrix Conjugation::times_blocks(const ComplexMatrix& a, const Vector& x) const {
  const Index m = size();
  const double half = std::sqrt(0.5);
  ComplexMatrix y = ComplexMatrix::Zero(a.rows(), a.cols());
  for (Index v = 0; v < m; ++v) {
    const auto [i, j] = unknowns_[static_cast<std::size_t>(v)];
    const Complex d = Complex(x(v), x(m + v)) * (i == j ? 1.0 : half);
    y.col(j) += d * a.col(i);
    if (i != j) y.col(i) += d * a.col(j);
  }
  return y;
}

Matrix Conjugation::real_part(const Vector& x) const {
  const ComplexMatrix y = times_blocks(u_.conjugate(), x);
  const Matrix y_re = y.real(), y_im = y.imag(), u_re = u_.real(), u_im = u_.imag();
  Matrix re = lapack::multiply_nt(y_re, u_re);
  lapack::multiply_into(re, 1, y_im, false, u_im, true, 1);
  return 0.5 * (re + re.transpose());
}

// Every block the unitary factor of its polar decomposition; a phase where it is a number.
void Conjugation::make_blocks_unitary(Vector& x) const {
  const Index m = size();
  const double half = std::sqrt(0.5);
  Index v = 0;
  for (const Cluster& c : clusters_) {
    if (c.count == 1) {
      const double size = std::hypot(x(v), x(m + v));
      if (size > 0) x(v) /= size, x(m + v) /= size;
      ++v;
      continue;
    }
    ComplexMatrix block(c.count, c.count);
    Index at = v;
    for (Index j = 0; j < c.count; ++j) {
      for (Index i = 0; i <= j; ++i, ++at) block(i, j) = block(j, i) = Complex(x(at), x(m + at)) * (i == j ? 1.0 : half);
    }
    const small::Svd svd = small::singular_value_decomposition(block);
    const ComplexMatrix unitary = svd.u * svd.v.adjoint();
    for (Index j = 0; j < c.count; ++j) {
      for (Index i = 0; i <= j; ++i, ++v) {
        const Complex d = 0.5 * (unitary(i, j) + unitary(j, i)) / (i == j ? 1.0 : half);
        x(v) = d.real();
        x(m + v) = d.imag();
      }
    }
  }
}

Matrix Conjugation::by_strongest_couplings(const Vector& noise) const {
  constexpr int averages = 4;
  const Index m = size();
  const ComplexVector phases = phases_by_couplings(w_, noise);
  Vector x = Vector::Zero(2 * m);
  for (Index v = 0, c = 0; c < static_cast<Index>(clusters_.size()); ++c) {
    const Cluster& cluster = clusters_[static_cast<std::size_t>(c)];
    if (cluster.count == 1) {  // those of clusters stay 0 until the others say what they are
      x(v) = phases(cluster.first).real();
      x(m + v) = phases(cluster.first).imag();
    }
    v += cluster.count * (cluster.count + 1) / 2;
  }
  for (int k = 0; k < averages; ++k) {
    x = applied(x);
    make_blocks_unitary(x);
  }
  return real_part(x);
}

}  // namespace gyromode
