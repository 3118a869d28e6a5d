#include "gyromode/dense/refinement/own_scale.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/basis.h"
#include "gyromode/dense/refinement/characteristic_factor.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/dense/refinement/simultaneous_roots.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/system/scale.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

Matrix matrix_at(const Impedance& h, double omega, const Matrix&) { return h.real_at(omega); }
ComplexMatrix matrix_at(const Impedance& h, double omega, const ComplexMatrix&) { return h.complex_at(omega); }

Matrix slope_at(const Impedance& h, double omega, const Matrix&) { return h.real_slope_at(omega); }
ComplexMatrix slope_at(const Impedance& h, double omega, const ComplexMatrix&) { return h.complex_slope_at(omega); }

// Fixed columns without structure.
template <class AnyMatrix>
AnyMatrix start(Index n, Index columns) {
  AnyMatrix x(n, columns);
  for (Index k = 0; k < columns; ++k) {
    for (Index i = 0; i < n; ++i)
      x(i, k) = std::sin(1.3 + 2.1 * static_cast<double>(i) + 3.7 * static_cast<double>(k) + 0.9 * static_cast<double>(i * k % 13));
  }
  return x;
}

// The modes in the span of x near ω by the Hermitian pencil (xᴴHx, xᴴH′x), where it is regular and they are near:
// frequencies and shapes are replaced.
template <class AnyMatrix>
void resolve(const Impedance& h, Eigen::Ref<Vector> omega, AnyMatrix& x) {
  constexpr double near = 1e-4;
  const double sigma = omega.mean();
  const ComplexMatrix a = (x.adjoint() * (matrix_at(h, sigma, AnyMatrix()) * x)).template cast<Complex>();
  const ComplexMatrix b = (x.adjoint() * (slope_at(h, sigma, AnyMatrix()) * x)).template cast<Complex>();
  auto roots = self_adjoint_pencil(0.5 * (a + a.adjoint()), 0.5 * (b + b.adjoint()));  // H(σ + δ) = H(σ) − δH′(σ) to first order
  if (static_cast<Index>(roots.size()) != omega.size()) return;
  for (const PencilRoot& r : roots) {
    if (r.value.imag() != 0 || !(std::abs(r.value.real()) <= near * sigma)) return;
  }
  std::sort(roots.begin(), roots.end(), [](const PencilRoot& p, const PencilRoot& q) { return p.value.real() < q.value.real(); });
  AnyMatrix shapes(x.rows(), x.cols());
  for (Index k = 0; k < omega.size(); ++k) {
    const PencilRoot& r = roots[static_cast<std::size_t>(k)];
    omega(k) = sigma + r.value.real();
    shapes.col(k) = (x * coefficients(r.y, AnyMatrix())).normalized();
  }
  x = std::move(shapes);
}

// Shapes of `count` modes near ω: what H(ω) takes nearly to zero, by inverse iteration on the equilibrated matrix. A
// column that it does not, as at a defective root, is replaced by the first.
template <class AnyMatrix>
AnyMatrix null_shapes(const Impedance& h, double omega, Index count) {
  const Vector weight = h.weight(omega);
  const Vector d = weight.unaryExpr([](double w) { return w > 0 ? power_of_two_near(1 / std::sqrt(w)) : 1; });
  AnyMatrix matrix = scaled(matrix_at(h, omega, AnyMatrix()), d);
  auto factor = lapack::factor_indefinite(matrix);
  AnyMatrix x = start<AnyMatrix>(h.size(), count);
  for (int step = 0; step < 3; ++step) {
    AnyMatrix y = lapack::solve(factor, x);
    if (!y.allFinite()) {  // singular to the last bit: one rounding error away it is not
      matrix.diagonal().array() += 4 * epsilon;
      factor = lapack::factor_indefinite(matrix);
      y = lapack::solve(factor, x);
    }
    if (!y.allFinite()) break;
    y.colwise().normalize();
    x = orthonormal_basis(y);
  }
  const AnyMatrix image = matrix * x;
  const double rounding = 1e3 * static_cast<double>(h.size()) * epsilon;
  Index best = 0;
  image.colwise().norm().minCoeff(&best);
  for (Index k = 0; k < count; ++k) {
    if (!(image.col(k).norm() <= std::max(rounding, 10 * image.col(best).norm()))) x.col(k) = x.col(best);
  }
  x = (d.asDiagonal() * x).eval();
  x.colwise().normalize();
  return x;
}

void store(const Impedance& h, Spectrum& s, Index at, const Matrix& x) {
  s.re.middleCols(at, x.cols()) = x.topRows(h.split());
  s.im.middleCols(at, x.cols()) = -x.bottomRows(h.size() - h.split());
}
void store(const Impedance&, Spectrum& s, Index at, const ComplexMatrix& x) {
  s.re.middleCols(at, x.cols()) = x.real();
  s.im.middleCols(at, x.cols()) = x.imag();
}

// Modes nearer than this share one span.
constexpr double close = 1e-7;

template <class AnyMatrix>
void add_modes(const Impedance& h, std::vector<double> omega, Spectrum& s) {
  std::sort(omega.begin(), omega.end());
  const Index m = static_cast<Index>(omega.size());
  s.omega = Eigen::Map<const Vector>(omega.data(), m);
  s.re.resize(h.quadrature() ? h.split() : h.size(), m);
  s.im.resize(h.quadrature() ? h.size() - h.split() : h.size(), m);
  for (Index first = 0, last; first < m; first = last) {
    last = first + 1;
    while (last < m && s.omega(last) - s.omega(last - 1) <= close * s.omega(last)) ++last;
    AnyMatrix x = null_shapes<AnyMatrix>(h, s.omega.segment(first, last - first).mean(), last - first);
    if (last - first > 1) resolve<AnyMatrix>(h, s.omega.segment(first, last - first), x);
    store(h, s, first, x);
  }
}

void add_unstable(const Impedance& h, const std::vector<Complex>& roots, Spectrum& s) {
  for (const Complex& lambda : roots) {
    const NullPair v = null_pair(h, lambda);
    s.unstable.add(lambda, v.right, v.left);
  }
}

}  // namespace

std::optional<Spectrum> solve_in_own_scale(const Impedance& h, const Spectrum& known) {
  const auto mu = simultaneous_roots(h, h.size() - known.zero_pairs());
  if (!mu) return std::nullopt;
  Spectrum s = known;
  s.unstable = {};
  std::vector<double> omega;
  std::vector<Complex> off_axis;
  for (const Complex& z : *mu) {
    if (z.imag() == 0 && z.real() < 0) omega.push_back(std::sqrt(-z.real()));
    if (z.imag() == 0 && z.real() > 0) off_axis.emplace_back(std::sqrt(z.real()), 0);
    if (z.imag() > 0) off_axis.push_back(std::sqrt(z));  // principal: both parts above 0
  }
  if (h.quadrature())
    add_modes<Matrix>(h, omega, s);
  else
    add_modes<ComplexMatrix>(h, omega, s);
  add_unstable(h, off_axis, s);
  s.solver += " (one scale did not convince: every root by simultaneous iteration in its own)";
  return s;
}

}  // namespace gyromode::dense
