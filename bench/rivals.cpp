#include "rivals.h"

#include "gyromode/lapack/lapacke_complex.h"
#include "gyromode/lapack/status.h"

#include <Eigen/Cholesky>

namespace gyromode::bench {

namespace {

int order_of(const Matrix& a) { return lapack::dimension(a.rows(), "a rival"); }

}  // namespace

Dsyevd::Dsyevd(Matrix a) : a_(std::move(a)), values_(a_.rows()) {}

void Dsyevd::reset() { work_ = a_; }

void Dsyevd::solve() {
  const int n = order_of(work_);
  lapack::require_success(LAPACKE_dsyevd(LAPACK_COL_MAJOR, 'V', 'L', n, work_.data(), n, values_.data()), "dsyevd", "no convergence");
}

Dsygvd::Dsygvd(Matrix a, Matrix b) : a_(std::move(a)), b_(std::move(b)), values_(a_.rows()) {}

void Dsygvd::reset() {
  work_a_ = a_;
  work_b_ = b_;
}

void Dsygvd::solve() {
  const int n = order_of(work_a_);
  const int info = LAPACKE_dsygvd(LAPACK_COL_MAJOR, 1, 'V', 'L', n, work_a_.data(), n, work_b_.data(), n, values_.data());
  lapack::require_success(info, "dsygvd", "no convergence, or B is not positive definite");
}

Dgeev::Dgeev(Matrix a) : a_(std::move(a)), vectors_(a_.rows(), a_.rows()), re_(a_.rows()), im_(a_.rows()) {}

void Dgeev::reset() { work_ = a_; }

void Dgeev::solve() {
  const int n = order_of(work_);
  const int info = LAPACKE_dgeev(LAPACK_COL_MAJOR, 'N', 'V', n, work_.data(), n, re_.data(), im_.data(), nullptr, 1, vectors_.data(), n);
  lapack::require_success(info, "dgeev", "no convergence");
}

std::vector<Index> Dgeev::upper() const {
  std::vector<Index> positions;
  for (Index k = 0; k < im_.size(); ++k) {
    if (im_(k) > 0) positions.push_back(k);
  }
  return positions;
}

// LAPACK packs a conjugate pair as real part, imaginary part, the root with Im λ > 0 first.
ComplexVector Dgeev::vector(Index k) const {
  ComplexVector x(vectors_.rows());
  x.real() = vectors_.col(k);
  x.imag() = vectors_.col(k + 1);
  return x;
}

Matrix companion(const System& system) {
  const Index n = system.size();
  const Eigen::LLT<Matrix> mass(system.mass());
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topLeftCorner(n, n) = -mass.solve(system.gyroscopic());
  a.topRightCorner(n, n) = -mass.solve(system.stiffness());
  a.bottomLeftCorner(n, n).setIdentity();
  return a;
}

}  // namespace gyromode::bench
