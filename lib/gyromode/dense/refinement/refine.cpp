#include "gyromode/dense/refinement/refine.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/basis.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/small.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>

namespace gyromode::dense {

namespace {

// Shapes of a group: real X* with a partition (X = T X*), complex X without.
Matrix taken(const Spectrum& s, const std::vector<Index>& group, const Matrix&) {
  Matrix x(s.size(), static_cast<Index>(group.size()));
  x << s.re(Eigen::all, group), -s.im(Eigen::all, group);
  return x;
}

ComplexMatrix taken(const Spectrum& s, const std::vector<Index>& group, const ComplexMatrix&) {
  ComplexMatrix x(s.size(), static_cast<Index>(group.size()));
  x.real() = s.re(Eigen::all, group);
  x.imag() = s.im(Eigen::all, group);
  return x;
}

void stored(Spectrum& s, Index position, const Vector& x) {
  s.re.col(position) = x.head(s.split);
  s.im.col(position) = -x.tail(s.size() - s.split);
}

void stored(Spectrum& s, Index position, const ComplexVector& x) {
  s.re.col(position) = x.real();
  s.im.col(position) = x.imag();
}

// H(σ) and H′(σ) = −dH/dσ, real with a partition.
struct RealPair {
  Matrix value, slope;
};
struct ComplexPair {
  ComplexMatrix value, slope;
};
RealPair at(const Impedance& h, double omega, const Matrix&) { return {h.real_at(omega), h.real_slope_at(omega)}; }
ComplexPair at(const Impedance& h, double omega, const ComplexMatrix&) { return {h.complex_at(omega), h.complex_slope_at(omega)}; }

double largest_step(const std::vector<PencilRoot>& roots) {
  double step = 0;
  for (const PencilRoot& r : roots) step = std::max(step, std::abs(r.value));
  return step;
}

// A matrix that is singular to the last bit has no inverse to iterate with; one rounding error away it has.
template <class AnyMatrix>
AnyMatrix shifted_by_rounding(const AnyMatrix& h, int attempt) {
  AnyMatrix shifted = h;
  const double step = std::ldexp(epsilon, 2 * attempt);
  const Vector rows = h.cwiseAbs().rowwise().maxCoeff();
  shifted.diagonal() += (step * rows).template cast<typename AnyMatrix::Scalar>();
  return shifted;
}

template <class AnyMatrix>
AnyMatrix inverse_iterated(const AnyMatrix& h, const AnyMatrix& x, int steps) {
  AnyMatrix y = x;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Vector d = equilibrating_scale(h);
    const auto factor = lapack::factor_indefinite(scaled(attempt == 0 ? h : shifted_by_rounding(h, attempt), d));
    y = x;
    for (int step = 0; step < steps && y.allFinite(); ++step) {
      y = d.asDiagonal() * lapack::solve(factor, AnyMatrix(d.asDiagonal() * y));
      y.colwise().normalize();
    }
    if (y.allFinite()) break;
  }
  return y;
}

// xᴴMx.
double mass_of(const Impedance& h, const ComplexMatrix& x) {
  const Matrix re = x.real();
  const Matrix im = x.imag();
  return (re.transpose() * h.mass_rr() * re).value() + (im.transpose() * h.mass_rr() * im).value();
}
double mass_of(const Impedance& h, const Matrix& x) {
  const Index p = h.mass_rr().rows();
  const Vector first = x.col(0).head(p);
  const Vector second = x.col(0).tail(x.rows() - p);
  return first.dot(h.mass_rr() * first) + second.dot(h.mass_ii() * second);
}

// The smaller root δ of a − δb − δ²m = xᴴH(σ + δ)x = 0. Near a defective root b is small and the quadratic term counts;
// where the discriminant is negative the roots of the functional are complex, and nothing real can be said.
Complex quadratic_step(double a, double b, double m) {
  const double discriminant = b * b + 4 * m * a;
  if (discriminant < 0) return {0, 1};
  const double sum = b + std::copysign(std::sqrt(discriminant), b);
  return sum == 0 ? 0 : 2 * a / sum;
}

// ‖Dr‖/‖D⁻¹x‖ in each coefficient's own scale (Impedance::weight).
template <class AnyMatrix>
double worst_residual(const Impedance& h, const Spectrum& s, const std::vector<Index>& group) {
  double worst = 0;
  for (const Index i : group) {
    const AnyMatrix x = taken(s, {i}, AnyMatrix());
    const Vector weight = h.weight(s.omega(i));
    const Vector r2 = (at(h, s.omega(i), x).value * x).cwiseAbs2();
    worst = std::max(worst, std::sqrt((weight.array() > 0).select(r2.cwiseQuotient(weight), 0).sum() / weight.dot(Vector(x.cwiseAbs2()))));
  }
  return worst;
}

template <class AnyMatrix>
bool refine_group(const Impedance& h, Spectrum& s, const std::vector<Index>& group, double reach) {
  constexpr int most_steps = 5;
  AnyMatrix x = taken(s, group, AnyMatrix());
  double sigma = 0;
  for (const Index i : group) sigma += s.omega(i) / static_cast<double>(group.size());
  const double start = sigma;
  std::vector<PencilRoot> roots;
  double previous = infinity;
  for (int step = 0; step < most_steps; ++step) {
    const auto pair = at(h, sigma, x);
    const AnyMatrix y = inverse_iterated(pair.value, AnyMatrix(pair.slope * x), 1);
    if (!y.allFinite()) return false;
    x = orthonormal_basis(y);
    const AnyMatrix a = x.adjoint() * (pair.value * x);
    const AnyMatrix b = x.adjoint() * (pair.slope * x);
    const auto as_complex = [](const AnyMatrix& m) { return ComplexMatrix((0.5 * (m + m.adjoint())).template cast<Complex>()); };
    const double direction = h.second_order() ? 1 : -1;  // H(σ + δ) = H(σ) ∓ δ·slope to first order
    roots = self_adjoint_pencil(direction * as_complex(a), as_complex(b));
    if (roots.size() != group.size()) return false;
    if (group.size() == 1 && h.second_order()) roots[0].value = quadratic_step(std::real(a(0, 0)), std::real(b(0, 0)), mass_of(h, x));
    double mean = 0;
    for (const PencilRoot& r : roots) {
      if (r.value.imag() != 0 || !(std::abs(r.value.real()) <= reach + 4 * epsilon * sigma)) return false;
      mean += r.value.real() / static_cast<double>(roots.size());
    }
    const double change = largest_step(roots);
    if (change <= 4 * epsilon * sigma || (group.size() > 1 && step > 1) || !(change < 0.5 * previous)) break;
    previous = change;
    sigma += mean;
    for (PencilRoot& r : roots) r.value -= mean;
    if (!(std::abs(sigma - start) <= reach + 4 * epsilon * start)) return false;
  }
  if (roots.size() != group.size()) return false;
  std::sort(roots.begin(), roots.end(), [](const PencilRoot& p, const PencilRoot& q) { return p.value.real() < q.value.real(); });
  const double before = worst_residual<AnyMatrix>(h, s, group);
  using AnyVector = Eigen::Matrix<typename AnyMatrix::Scalar, Eigen::Dynamic, 1>;
  const Vector kept_omega = s.omega(group);
  const AnyMatrix kept_shapes = taken(s, group, AnyMatrix());
  for (std::size_t k = 0; k < group.size(); ++k) {
    s.omega(group[k]) = sigma + roots[k].value.real();
    stored(s, group[k], AnyVector(x * coefficients(roots[k].y, AnyMatrix())));
  }
  if (worst_residual<AnyMatrix>(h, s, group) < before) return true;
  for (std::size_t k = 0; k < group.size(); ++k) {
    s.omega(group[k]) = kept_omega(static_cast<Index>(k));
    stored(s, group[k], AnyVector(kept_shapes.col(static_cast<Index>(k))));
  }
  return false;
}

// Where first order fails, near a defective root: the shape alone, as the null vector of H at the root as it is. The
// smallest eigenvalue of H is quadratic in the distance from a defective root, so its residual is at rounding although
// ω has half the digits.
template <class AnyMatrix>
bool refine_shapes(const Impedance& h, Spectrum& s, const std::vector<Index>& group) {
  bool changed = false;
  for (const Index i : group) {
    AnyMatrix x = taken(s, {i}, AnyMatrix());
    x.normalize();
    const auto pair = at(h, s.omega(i), x);
    const double before = (pair.value * x).norm();
    const AnyMatrix y = inverse_iterated(pair.value, x, 2);
    if (!y.allFinite() || !((pair.value * y).norm() < before)) continue;
    const Eigen::Matrix<typename AnyMatrix::Scalar, Eigen::Dynamic, 1> shape = y;
    stored(s, i, shape);
    changed = true;
  }
  return changed;
}

// Nearly parallel shapes at close roots are a nearly defective pair: its shapes do not span the group, and each root is
// followed alone, no farther than a part of the way to its neighbour.
template <class AnyMatrix>
bool parallel(const Spectrum& s, const std::vector<Index>& group) {
  constexpr double limit = 1e-2;
  const AnyMatrix x = taken(s, group, AnyMatrix()).colwise().normalized();
  return small::hermitian_eigenvalues(ComplexMatrix((x.adjoint() * x).template cast<Complex>()))(0) < limit * limit;
}

template <class AnyMatrix>
bool refine_each(const Impedance& h, Spectrum& s, const std::vector<Index>& group, double reach) {
  bool changed = false;
  for (const Index i : group) {
    double room = reach;
    if (i > 0) room = std::min(room, 0.4 * (s.omega(i) - s.omega(i - 1)));
    if (i + 1 < s.omega.size()) room = std::min(room, 0.4 * (s.omega(i + 1) - s.omega(i)));
    changed = refine_group<AnyMatrix>(h, s, {i}, room) || changed;
    changed = refine_shapes<AnyMatrix>(h, s, {i}) || changed;  // ω is not known better than the form allows; its null vector is
  }
  return changed;
}

template <class AnyMatrix>
bool refined(const Impedance& h, Spectrum& s, const std::vector<Index>& group, double reach) {
  if (group.size() == 1 || parallel<AnyMatrix>(s, group)) return refine_each<AnyMatrix>(h, s, group, reach);
  return refine_group<AnyMatrix>(h, s, group, reach) || refine_shapes<AnyMatrix>(h, s, group);
}

}  // namespace

bool refine(const Impedance& h, Spectrum& s, const std::vector<Index>& group, double reach) {
  return h.quadrature() ? refined<Matrix>(h, s, group, reach) : refined<ComplexMatrix>(h, s, group, reach);
}

}  // namespace gyromode::dense
