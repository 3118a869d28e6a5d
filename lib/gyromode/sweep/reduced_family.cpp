#include "gyromode/sweep/reduced_family.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/inertia.h"
#include "gyromode/lapack/small.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sweep/family_structure.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace gyromode {

namespace {

// T* x, up to a phase real for the shapes of a partition: the larger of its two parts.
Vector in_phases(const ComplexVector& shape, const QuadratureAxes& axes) {
  const ComplexVector x = axes.own(shape);
  return x.real().squaredNorm() >= x.imag().squaredNorm() ? Vector(x.real()) : Vector(x.imag());
}

bool all_stable(const std::vector<SpinSample>& solved) {
  return std::all_of(solved.begin(), solved.end(), [](const SpinSample& s) {
    return s.stability == Stability::stable && s.balance.closed && s.balance.zero == 0 && s.balance.negative == 0 &&
           std::all_of(s.modes.begin(), s.modes.end(), [](const SampledMode& m) { return m.block >= 0 && m.energy_sign == 1; });
  });
}

}  // namespace

bool ReducedFamily::take(const SpinFamily& f) {
  if (f.stiffness_per_spin2.size() > 0) return false;
  const Structure structure = structure_of(f);
  if (structure.system_class() != SystemClass::quadrature) return false;
  const Index n = f.mass.rows();
  std::vector<Index> all(static_cast<std::size_t>(n));
  std::iota(all.begin(), all.end(), Index{0});
  axes_ = QuadratureAxes(all, structure.in_quadrature());
  stiffness_ = 0.5 * (f.stiffness + f.stiffness.transpose());
  mass_ = 0.5 * (f.mass + f.mass.transpose());
  const auto part = [&](const Matrix& g) { return g.size() > 0 ? axes_.crossed(0.5 * (g - g.transpose())) : Matrix::Zero(n, n); };
  constant_ = part(f.gyroscopic);
  per_spin_ = part(f.gyroscopic_per_spin);
  factor_ = lapack::Cholesky(stiffness_);
  return factor_.positive();
}

// V = L⁻ᵀQ, Q an orthonormal basis of the shapes in coordinates where K = 1.
void ReducedFamily::add_block(Index number, const Matrix& shapes) {
  constexpr double same = 1e-8;  // below: what rounding has put of other blocks into the shapes
  Matrix x = shapes;
  lapack::multiply_lower_transposed(factor_.lower(), x);
  x.colwise().normalize();
  Block b;
  b.number = number;
  b.basis = small::ranked_qr(x, same).q;
  lapack::solve_lower_transposed(factor_.lower(), b.basis);
  b.k_basis = stiffness_ * b.basis;
  b.m_basis = mass_ * b.basis;
  b.b0_basis = constant_ * b.basis;
  b.b1_basis = per_spin_ * b.basis;
  const auto reduced = [&](const Matrix& a) -> Matrix {
    const Matrix r = b.basis.transpose() * a;
    return 0.5 * (r + r.transpose());
  };
  b.mass = reduced(b.m_basis);
  b.constant = reduced(b.b0_basis);
  b.per_spin = reduced(b.b1_basis);
  b.mass_root = lapack::Cholesky(b.mass).lower();
  blocks_.push_back(std::move(b));
}

std::optional<ReducedFamily> ReducedFamily::from(const SpinFamily& family, const FamilyBlocks& blocks,
                                                 const std::vector<SpinSample>& solved, const std::vector<OrbitCoordinates>& places) {
  ReducedFamily r;
  if (!all_stable(solved) || !r.take(family)) return std::nullopt;
  r.places_ = places;
  r.usual_ = solved.front();
  r.usual_.modes.clear();
  std::map<Index, std::vector<Vector>> shapes;
  for (const SpinSample& s : solved) {
    for (const SampledMode& m : s.modes) {
      if (!blocks.is_pure(m.shape)) continue;
      shapes[m.block].push_back(in_phases(m.shape, r.axes_));
      r.rounding_.emplace_back(m.omega, m.error / m.omega);
    }
  }
  for (const auto& [number, of_block] : shapes) {
    Matrix all(r.mass_.rows(), static_cast<Index>(of_block.size()));
    for (std::size_t k = 0; k < of_block.size(); ++k) all.col(static_cast<Index>(k)) = of_block[k];
    r.add_block(number, all);
  }
  return r;
}

// Relative to ω it falls with ω: of the roots from a little below on the largest.
double ReducedFamily::rounding_at(double omega) const {
  constexpr double little = 0.8;
  double relative = 0;
  for (const auto& [at, error] : rounding_) {
    if (at >= little * omega) relative = std::max(relative, error);
  }
  return relative * omega;
}

Index ReducedFamily::order() const {
  Index all = 0;
  for (const Block& b : blocks_) all += b.basis.cols();
  return all;
}

// With μ = 1/ω and ccᵀ = VᵀMV: μy + By − c z = 0, z = cᵀy/μ, a symmetric eigenvalue problem of twice the order.
void ReducedFamily::add_roots(const Block& b, double spin, std::vector<Root>& to) const {
  const Index r = b.basis.cols();
  Matrix a = Matrix::Zero(2 * r, 2 * r);
  a.topLeftCorner(r, r) = -(b.constant + spin * b.per_spin);
  a.topRightCorner(r, r) = b.mass_root;
  a.bottomLeftCorner(r, r) = b.mass_root.transpose();
  const lapack::SymmetricEigen e = lapack::symmetric_eigen(std::move(a));
  for (Index k = 2 * r - 1; k >= 0 && e.values(k) > 0; --k) {
    const Vector y = e.vectors.col(k).head(r);
    to.push_back({1 / e.values(k), &b, y / y.norm()});
  }
}

Matrix ReducedFamily::impedance(double omega, double spin) const {
  return stiffness_ + omega * (constant_ + spin * per_spin_) - omega * omega * mass_;
}

// With VᵀKV = 1: the residual in the norm of K⁻¹, and the slope of the root. The Rayleigh quotient of Vy is 0, so that
// an eigenvalue of H(ω) is within ρ of 0, and within ρ²/g where the others of the block are farther than g (Kato and
// Temple), about the slope times the distance of their roots.
SampledMode ReducedFamily::sampled(const Root& root, double spin, double apart) const {
  const Block& b = *root.block;
  const double w = root.omega;
  const Vector& y = root.y;
  const double per_spin = y.dot(b.per_spin * y), form = 2 * w * y.dot(b.mass * y) - y.dot(b.constant * y) - spin * per_spin;
  Matrix residual = b.k_basis * y + w * (b.b0_basis * y + spin * (b.b1_basis * y)) - w * w * (b.m_basis * y);
  lapack::solve_lower(factor_.lower(), residual);
  SampledMode m;
  m.omega = w;
  const double rho = residual.norm();
  m.error = std::min(rho, rho * rho / (form * apart)) / form + rounding_at(w);
  m.slope = w * per_spin / form;
  m.block = b.number;
  m.shape = normalised(axes_.given((b.basis * y).cast<Complex>()));
  m.whirl = whirl_of(m.shape, places_, spin);
  m.fixed_axes = in_fixed_axes(m.shape, w, spin, places_);
  return m;
}

std::optional<SpinSample> ReducedFamily::at(double spin, double below, std::optional<Index> lowest) const {
  std::vector<Root> roots;
  for (const Block& b : blocks_) add_roots(b, spin, roots);
  std::stable_sort(roots.begin(), roots.end(), [](const Root& a, const Root& b) { return a.omega < b.omega; });
  SpinSample s = usual_;
  s.spin = spin;
  s.coverage = {};
  s.coverage.requested.b = lowest ? infinity : below;
  std::size_t count = 0;
  double end = below;
  if (lowest) {
    constexpr double apart = 1e-9;  // of ω: roots nearer than this are not parted by the window
    count = std::min(static_cast<std::size_t>(*lowest), roots.size());
    while (count < roots.size() && roots[count].omega - roots[count - 1].omega <= apart * roots[count].omega) ++count;
    end = count < roots.size() ? 0.5 * (roots[count - 1].omega + roots[count].omega) : 1.01 * roots.back().omega;
  } else {
    while (count < roots.size() && roots[count].omega < below) ++count;
  }
  constexpr double enough = 1e-10;
  for (std::size_t k = 0; k < count; ++k) {
    double apart = infinity;
    for (const Root& other : roots) {
      if (&other != &roots[k] && other.block == roots[k].block) apart = std::min(apart, std::abs(other.omega - roots[k].omega));
    }
    s.modes.push_back(sampled(roots[k], spin, apart));
    if (!(s.modes.back().error <= enough * roots[k].omega + rounding_at(roots[k].omega))) return std::nullopt;
  }
  s.coverage.window = {0, end};
  const Inertia there = inertia(impedance(end, spin));
  s.coverage.found = static_cast<Index>(count);
  s.coverage.counted = there.negative;
  if (there.doubtful() || there.negative != s.coverage.found) return std::nullopt;
  s.coverage.status = CoverageStatus::complete;
  return s;
}

}  // namespace gyromode
