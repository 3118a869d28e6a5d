#include "gyromode/structure/conjugation.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"

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

}  // namespace

void Conjugation::decompose() {
  if (size() <= dense_unknowns)
    decompose_densely();
  else
    decompose_by_lanczos();
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

// Lanczos with full reorthogonalisation. Of a multiple eigenvalue one vector is found, which is as generic as the
// start.
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

// σ = 1 − ‖Im X‖²: eigenvalues tell ‖Im X‖ to √ε only. On the span of the vectors beside 1 the singular values of the
// linear map D ↦ Im X tell it to ε. They are those of D ↦ SᵀIm(X)Z with random S and Z, p columns each, to a factor
// near 1, as p² is several times the dimension: a matrix of p² rows instead of n².
void Conjugation::sharpen() {
  constexpr double beside = 1e-5;
  constexpr Index most = 256;
  std::vector<Index> top;
  for (Index k = values_.size(); k-- > 0 && static_cast<Index>(top.size()) < most;) {
    if (values_(k) >= largest() - beside) top.push_back(k);
  }
  const Matrix chosen = vectors_(Eigen::all, top);
  const Index n = u_.rows();
  const Index p = std::min(n, static_cast<Index>(std::sqrt(8.0 * static_cast<double>(top.size()))) + 8);
  const auto svd = lapack::singular_value_decomposition(
      lapack::multiply(imaginary_part(gaussian(n * p, 3).reshaped(n, p), gaussian(n * p, 4).reshaped(n, p)), chosen));
  vectors_ = lapack::multiply_nt(chosen, svd.vt);
  departures_ = svd.values / static_cast<double>(p);
}

// (Re D, Im D) ↦ SᵀIm(X)Z, p² × 2 size().
Matrix Conjugation::imaginary_part(const Matrix& s, const Matrix& z) const {
  const Index m = size(), p = s.cols();
  const double half = std::sqrt(0.5);
  const auto both = [](const ComplexMatrix& u, const Matrix& a) {
    ComplexMatrix product(a.cols(), u.cols());
    product.real() = lapack::multiply_tn(a, u.real());
    product.imag() = lapack::multiply_tn(a, u.imag());
    return ComplexMatrix(product.conjugate());
  };
  const ComplexMatrix left = both(u_, s), right = both(u_, z);  // SᵀŪ, and (UᴴZ)ᵀ
  Matrix map(p * p, 2 * m);
  for (Index v = 0; v < m; ++v) {
    const auto [i, j] = unknowns_[static_cast<std::size_t>(v)];
    ComplexMatrix x = left.col(i) * right.col(j).transpose();
    if (i != j) x = half * (x + left.col(j) * right.col(i).transpose()).eval();
    map.col(v) = Matrix(x.imag()).reshaped();
    map.col(m + v) = Matrix(x.real()).reshaped();
  }
  return map;
}

Matrix Conjugation::real_element(double spread, std::uint64_t seed) const {
  const Vector weight = gaussian(departures_.size(), seed);
  Vector x = Vector::Zero(2 * size());
  for (Index k = 0; k < departures_.size(); ++k) {
    const double decay = std::exp(-(departures_(k) - departures_.minCoeff()) / spread);
    if (decay > 1e-12) x += weight(k) * decay * vectors_.col(k);
  }
  // With D its unitary factor solves D = W D̄ W, and gives the sign of X: without it a random combination of many
  // solutions has eigenvalues near 0, whose sign is lost.
  make_blocks_unitary(x);
  return real_part(x);
}

}  // namespace gyromode
