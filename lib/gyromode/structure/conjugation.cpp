#include "gyromode/structure/conjugation.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/structure/phases.h"

#include <Eigen/QR>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr Index dense_unknowns = 500;  // D has so many entries at most where its whole spectrum is computed
constexpr Index lanczos_steps = 150;

Vector gaussian(Index n, std::uint64_t seed) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  Vector x(n);
  for (double& v : x) v = normal(bits);
  return x;
}

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
    if (i > 0 && ascending(i) - ascending(i - 1) <= width) ++clusters.back().count;
    else clusters.push_back({i, 1});
  }
  return clusters;
}

Conjugation::Conjugation(ComplexMatrix u, std::vector<Cluster> clusters) : u_(std::move(u)), clusters_(std::move(clusters)), w_(self_product(u_)) {
  for (const Cluster& c : clusters_) {
    for (Index j = c.first; j < c.first + c.count; ++j) {
      for (Index i = c.first; i <= j; ++i) unknowns_.push_back({i, j});
    }
  }
}

void Conjugation::decompose() {
  if (size() <= dense_unknowns) decompose_densely();
  else decompose_by_lanczos();
  sharpen();
}

// B d̄ with B the coefficients of W E_v W on E_u: on (Re d, Im d) the symmetric matrix [Re B, Im B; Im B, −Re B].
Matrix Conjugation::operator_matrix() const {
  const Index m = size();
  Matrix a(2 * m, 2 * m);
  for (Index v = 0; v < m; ++v) {
    const auto [k, l] = unknowns_[static_cast<std::size_t>(v)];
    for (Index r = 0; r < m; ++r) {
      const auto [i, j] = unknowns_[static_cast<std::size_t>(r)];
      Complex b = w_(i, k) * w_(l, j);
      if (k != l) b = (b + w_(i, l) * w_(k, j)) / std::sqrt(2.0);
      if (i != j) b *= std::sqrt(2.0);
      a(r, v) = b.real();
      a(m + r, v) = a(r, m + v) = b.imag();
      a(m + r, m + v) = -b.real();
    }
  }
  return a;
}

void Conjugation::decompose_densely() {
  auto e = lapack::symmetric_eigen(operator_matrix());
  const Index keep = size();  // eigenvalues come as ±σ: the upper half
  values_ = e.values.tail(keep);
  vectors_ = e.vectors.rightCols(keep);
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

// Lanczos with full reorthogonalisation. Of a multiple eigenvalue one vector is found, which is as generic as the start.
void Conjugation::decompose_by_lanczos() {
  const Index steps = std::min(lanczos_steps, 2 * size());
  Matrix q(2 * size(), steps + 1);
  Matrix t = Matrix::Zero(steps, steps);
  q.col(0) = gaussian(2 * size(), 1).normalized();
  Index k = 0;
  for (; k < steps; ++k) {
    Vector y = applied(q.col(k));
    t(k, k) = q.col(k).dot(y);
    for (int pass = 0; pass < 2; ++pass) y -= q.leftCols(k + 1) * (q.leftCols(k + 1).transpose() * y);
    const double beta = y.norm();
    if (k + 1 < steps) t(k + 1, k) = t(k, k + 1) = beta;
    if (!(beta > 1e-13)) {
      ++k;
      break;
    }
    q.col(k + 1) = y / beta;
  }
  const auto e = lapack::symmetric_eigen(t.topLeftCorner(k, k));
  values_ = e.values;
  vectors_ = lapack::multiply(q.leftCols(k), e.vectors);
}

ComplexMatrix Conjugation::left_factor(const Vector& x) const {
  const Index m = size();
  const double half = std::sqrt(0.5);
  ComplexMatrix y = ComplexMatrix::Zero(u_.rows(), u_.cols());  // Ū D
  for (Index v = 0; v < m; ++v) {
    const auto [i, j] = unknowns_[static_cast<std::size_t>(v)];
    const Complex d = Complex(x(v), x(m + v)) * (i == j ? 1.0 : half);
    y.col(j) += d * u_.col(i).conjugate();
    if (i != j) y.col(i) += d * u_.col(j).conjugate();
  }
  return y;
}

ComplexMatrix Conjugation::element(const Vector& x) const {
  const ComplexMatrix y = left_factor(x);
  const Matrix y_re = y.real(), y_im = y.imag(), u_re = u_.real(), u_im = u_.imag();
  ComplexMatrix z(u_.rows(), u_.rows());
  z.real() = lapack::multiply_nt(y_re, u_re) + lapack::multiply_nt(y_im, u_im);
  z.imag() = lapack::multiply_nt(y_im, u_re) - lapack::multiply_nt(y_re, u_im);
  return z;
}

// σ = 1 − ‖Im X‖²: eigenvalues tell ‖Im X‖ to √ε only. On the span of the vectors beside 1 the singular values of the linear map D ↦ Im X tell it to ε.
void Conjugation::sharpen() {
  constexpr double beside = 1e-5, work = 2e10;  // of the orthogonalisation, operations
  const double n2 = static_cast<double>(u_.rows()) * static_cast<double>(u_.rows());
  const Index most = std::max<Index>(8, static_cast<Index>(std::sqrt(work / (2 * n2))));
  std::vector<Index> top;
  for (Index k = values_.size(); k-- > 0 && static_cast<Index>(top.size()) < most;) {
    if (values_(k) >= largest() - beside) top.push_back(k);
  }
  const Index n = u_.rows();
  Matrix imaginary(n * n, static_cast<Index>(top.size()));
  for (std::size_t k = 0; k < top.size(); ++k) imaginary.col(static_cast<Index>(k)) = element(vectors_.col(top[k])).imag().reshaped();
  const Eigen::HouseholderQR<Eigen::Ref<Matrix>> qr(imaginary);
  const Index q = imaginary.cols();
  const Matrix triangle = imaginary.topRows(q).triangularView<Eigen::Upper>();
  const auto svd = lapack::singular_value_decomposition(triangle);
  const Matrix chosen = vectors_(Eigen::all, top);
  vectors_ = lapack::multiply_nt(chosen, svd.vt);
  departures_ = svd.values;
}

Matrix Conjugation::real_element(double spread, std::uint64_t seed) const {
  const Vector weight = gaussian(departures_.size(), seed);
  Vector x = Vector::Zero(2 * size());
  for (Index k = 0; k < departures_.size(); ++k) {
    const double decay = std::exp(-(departures_(k) - departures_.minCoeff()) / spread);
    if (decay > 1e-12) x += weight(k) * decay * vectors_.col(k);
  }
  return real_part(x);
}

Matrix Conjugation::real_part(const Vector& x) const {
  const ComplexMatrix y = left_factor(x);
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
    const Eigen::JacobiSVD<ComplexMatrix> svd(block, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const ComplexMatrix unitary = svd.matrixU() * svd.matrixV().adjoint();
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
