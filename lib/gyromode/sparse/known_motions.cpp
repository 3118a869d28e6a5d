#include "gyromode/sparse/known_motions.h"

#include "gyromode/sparse/matrix.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gyromode::sparse {

namespace {

// Displacement X of a root λ and KX, as the equation of motion has it, −(λ²M + λG)X: with less rounding than a product.
struct Motion {
  ComplexVector x, kx;
  Complex lambda;
};

ComplexVector product(const Matrix& parts) { return parts.col(0) + Complex(0, 1) * parts.col(1); }

Motion motion_of(const SparseSystem& s, const ComplexVector& shape, Complex lambda) {
  ComplexVector x = shape;
  Index largest = 0;
  x.cwiseAbs().maxCoeff(&largest);
  x /= std::abs(x(largest));
  const Matrix parts = parts_of(x);
  const ComplexVector mx = product(symmetric_times(s.mass(), parts)), gx = product(skew_times(s.gyroscopic(), parts));
  return {std::move(x), -lambda * (lambda * mx + gx), lambda};
}

// Real states and E times them, in the order of coordinates.
class StatesOfKnown {
 public:
  StatesOfKnown(const SparseSystem& system, const Groups& groups, Index leads) : system_(system), groups_(groups), leads_(leads) {}

  void add(const Motion& m) {
    if (groups_.partition)
      add_by_groups(m);
    else
      add_pair(m);
  }
  States all() const {
    const Index rows = groups_.partition ? system_.size() : 2 * system_.size();
    States s{Matrix(rows, static_cast<Index>(x_.size())), Matrix(rows, static_cast<Index>(x_.size()))};
    for (std::size_t k = 0; k < x_.size(); ++k) {
      s.x.col(static_cast<Index>(k)) = x_[k];
      s.ex.col(static_cast<Index>(k)) = ex_[k];
    }
    return s;
  }

 private:
  // (q, q̇) of the real and the imaginary part of (X, λX).
  void add_pair(const Motion& m) {
    const ComplexVector rate = m.lambda * m.x;
    const Matrix velocity = parts_of(rate), momentum = symmetric_times(system_.mass(), velocity), x = parts_of(m.x), kx = parts_of(m.kx);
    for (Index part = 0; part < 2; ++part) {
      Vector z(2 * x.rows()), ez(2 * x.rows());
      z << x.col(part), velocity.col(part);
      ez << kx.col(part), momentum.col(part);
      keep(std::move(z), std::move(ez));
    }
  }
  // Displacements of the group that leads, velocities of the other: both of one phase, of flutter of two.
  void add_by_groups(const Motion& m) {
    const std::vector<Index>& leading = groups_.rows[static_cast<std::size_t>(leads_)];
    ComplexVector z = m.lambda * m.x;
    ComplexVector ez = product(symmetric_times(system_.mass(), parts_of(z)));
    for (const Index i : leading) {
      z(i) = m.x(i);
      ez(i) = m.kx(i);
    }
    Index largest = 0;
    z.cwiseAbs().maxCoeff(&largest);
    const Complex phase = std::conj(z(largest)) / std::abs(z(largest));
    z *= phase;
    ez *= phase;
    keep(z.real(), ez.real());
    if (m.lambda.real() != 0 && m.lambda.imag() != 0) keep(z.imag(), ez.imag());
  }
  void keep(Vector z, Vector ez) {
    x_.push_back(std::move(z));
    ex_.push_back(std::move(ez));
  }

  const SparseSystem& system_;
  const Groups& groups_;
  Index leads_;
  std::vector<Vector> x_, ex_;
};

}  // namespace

States states_of_known(const KnownMotions& known, const SparseSystem& system, const Groups& groups, Index leads) {
  StatesOfKnown states(system, groups, leads);
  for (const RitzMode& m : known.modes) states.add(motion_of(system, m.shape, Complex(0, m.omega)));
  for (const RitzUnstable& u : known.unstable) states.add(motion_of(system, u.shape, u.lambda));
  return states.all();
}

std::optional<TakenAway> orthogonal_to(const States& known, Index negative) {
  TakenAway t{known.x, {}, known.ex};
  for (Index k = 0; k < t.out.cols(); ++k) {
    const double size = std::sqrt(t.out.col(k).cwiseAbs().dot(t.e_out.col(k).cwiseAbs()));
    if (!(size > 0)) return std::nullopt;
    t.out.col(k) /= size;
    t.e_out.col(k) /= size;
  }
  const Matrix energy = t.out.transpose() * t.e_out, symmetric = 0.5 * (energy + energy.transpose());
  const Vector e = Eigen::SelfAdjointEigenSolver<Matrix>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  constexpr double near_zero = 1e-6;
  if ((e.array() < 0).count() != negative || e.cwiseAbs().minCoeff() < near_zero * e.cwiseAbs().maxCoeff()) return std::nullopt;
  t.weight = t.e_out * symmetric.fullPivLu().inverse();
  return t;
}

std::vector<Search::Expected> SearchBeside::look() const {
  std::vector<Expected> all = rest_->look();
  for (const RitzMode& m : known_.modes) all.push_back({m.omega, true});
  std::sort(all.begin(), all.end(), [](const Expected& a, const Expected& b) { return a.omega < b.omega; });
  return all;
}

Search::Found SearchBeside::found(const Window& range) const {
  Found f = rest_->found(range);
  std::copy_if(known_.modes.begin(), known_.modes.end(), std::back_inserter(f.modes),
               [&](const RitzMode& m) { return range.contains(m.omega); });
  std::stable_sort(f.modes.begin(), f.modes.end(), [](const RitzMode& a, const RitzMode& b) { return a.omega < b.omega; });
  if (range.a == 0) f.unstable.insert(f.unstable.end(), known_.unstable.begin(), known_.unstable.end());
  return f;
}

}  // namespace gyromode::sparse
