#include "gyromode/structure/conjugation.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/singular.h"
#include "gyromode/lapack/symmetric.h"

#include <Eigen/QR>

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
  for (std::size_t k = 0; k < top.size(); ++k) {
    const Matrix part = element(vectors_.col(top[k])).imag();
    imaginary.col(static_cast<Index>(k)) = part.reshaped();
  }
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

}  // namespace gyromode
