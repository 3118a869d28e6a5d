#include "gyromode/dense/classical/classical.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/ignorable.h"
#include "gyromode/dense/general/indefinite.h"
#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/singular_stiffness.h"
#include "gyromode/lapack/general.h"
#include "gyromode/lapack/hermitian.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace gyromode::dense {

namespace {

Matrix companion_matrix(const SecondOrder& m) {
  const Index n = m.size();
  const lapack::Cholesky mass(m.mass);
  Matrix a = Matrix::Zero(2 * n, 2 * n);
  a.topLeftCorner(n, n) = -mass.solve(m.gyroscopic);
  a.topRightCorner(n, n) = -mass.solve(m.stiffness);
  a.bottomLeftCorner(n, n).setIdentity();
  return a;
}

// Positions of the roots that are left when the `zeros` smallest are dropped, in the original order.
std::vector<Index> nonzero_roots(const ComplexVector& lambda, Index zeros) {
  std::vector<Index> order(static_cast<std::size_t>(lambda.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return std::abs(lambda(a)) < std::abs(lambda(b)); });
  order.erase(order.begin(), order.begin() + zeros);
  std::sort(order.begin(), order.end());
  return order;
}

// The roots ω > 0 of S y = −jωy, S = YᵀG*Y skew on the M*-orthonormal columns Y of one group of equal ω².
void append_group(const Matrix& y, const Matrix& g_star, Index n, std::vector<double>& omega, std::vector<ComplexVector>& shapes) {
  const Matrix s = lapack::multiply_tn(y, lapack::multiply(g_star, y));
  const ComplexMatrix hermitian = Complex(0, 0.5) * (s - s.transpose()).cast<Complex>();
  const auto e = lapack::hermitian_eigen(hermitian);
  const Index count = y.cols() / 2;
  for (Index k = y.cols() - count; k < y.cols(); ++k) {
    omega.push_back(e.values(k));
    shapes.push_back(y.bottomRows(n) * e.vectors.col(k));
  }
}

}  // namespace

void solve_companion(const SecondOrder& m, Spectrum& s) {
  const Index n = m.size();
  const StiffnessInertia d = inertia_of_k(m.stiffness);
  s.store_stiffness(d);
  const MassNormal normal(m.mass);
  const NormalForm form{normal.gyroscopic(m.gyroscopic), normal.stiffness(m.stiffness)};
  if (d.zero > 0) store_zero_modes(deflate({m.mass, m.gyroscopic, m.stiffness, -1}), d.null_space, s);
  const auto e = lapack::general_eigen(companion_matrix(m));
  const auto kept = nonzero_roots(e.values, 2 * s.zero_pairs());
  Matrix re = e.vectors.bottomRows(n).real()(Eigen::all, kept);
  Matrix im = e.vectors.bottomRows(n).imag()(Eigen::all, kept);
  normal.to_normal(re);
  normal.to_normal(im);
  ComplexMatrix z(n, re.cols());
  z.real() = re;
  z.imag() = im;
  IndefiniteModes modes = resolve_roots(form, e.values(kept), z);
  s.omega = std::move(modes.omega);
  s.unstable = std::move(modes.unstable);
  s.re = modes.shapes.real();
  s.im = modes.shapes.imag();
  normal.to_physical(s.re);
  normal.to_physical(s.im);
  normal.to_physical(s.unstable);
  s.solver = "first-order companion form of order 2n (asked for)";
}

void solve_symmetric_2n(const SecondOrder& m, Spectrum& s) {
  const Index n = m.size();
  const StiffnessInertia d = inertia_of_k(m.stiffness);
  s.store_stiffness(d);
  if (d.definiteness() != Definiteness::positive) {
    throw NotApplicable(
        fmt::format("method 'symmetric-2n' (Meirovitch 1974) needs K positive definite: K has {} negative and {} zero eigenvalues; 'auto' "
                    "applies",
                    d.negative, d.zero));
  }
  Matrix m_star = Matrix::Zero(2 * n, 2 * n);
  m_star.topLeftCorner(n, n) = m.mass;
  m_star.bottomRightCorner(n, n) = m.stiffness;
  Matrix g_star = Matrix::Zero(2 * n, 2 * n);
  g_star.topLeftCorner(n, n) = m.gyroscopic;
  g_star.topRightCorner(n, n) = m.stiffness;
  g_star.bottomLeftCorner(n, n) = -m.stiffness;
  const Matrix k_star = symmetric_part(lapack::multiply_tn(g_star, lapack::Cholesky(m_star).solve(g_star)));
  const auto e = lapack::symmetric_definite_eigen(k_star, m_star);

  std::vector<double> omega;
  std::vector<ComplexVector> shapes;
  constexpr double same = 1e-8;  // of ω²: a group holds every pair that rounding could have mixed
  for (Index first = 0, last; first < 2 * n; first = last) {
    last = first + 2;
    while (last < 2 * n && e.values(last) - e.values(last - 1) <= same * e.values(last)) last += 2;
    append_group(e.vectors.middleCols(first, last - first), g_star, n, omega, shapes);
  }
  std::vector<std::size_t> order(omega.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return omega[a] < omega[b]; });
  s.omega.resize(n);
  s.re.resize(n, n);
  s.im.resize(n, n);
  for (Index k = 0; k < n; ++k) {
    s.omega(k) = omega[order[static_cast<std::size_t>(k)]];
    s.re.col(k) = shapes[order[static_cast<std::size_t>(k)]].real();
    s.im.col(k) = shapes[order[static_cast<std::size_t>(k)]].imag();
  }
  s.solver = "two real symmetric matrices of order 2n after Meirovitch 1974 (asked for)";
}

}  // namespace gyromode::dense
