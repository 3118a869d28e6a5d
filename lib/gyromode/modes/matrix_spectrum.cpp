#include "gyromode/modes/matrix_spectrum.h"

#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

// The error bound of a root, and not less than what rounding of ω itself and a backward error of n ε leave open.
double open_error(const SolvedComponent& c, Index i) {
  const double omega = c.spectrum.omega(i);
  const double error = std::max(c.assessment.error_bound(i), backward_error(c.spectrum.size()) * c.assessment.sensitivity(i));
  return std::isfinite(error) ? std::max(error, 4 * epsilon * omega) : 1e-6 * omega;
}

// A shape and frequency whose residual rounding does not explain are no mode, whatever the counts say: error bounds
// hold for eigenpairs. The solvers leave some 7 n ε at most. Where every root was shown to exist, by bounds that hold
// the residual, a shape may be a hundred times worse: with K near singular its small part is that ill determined.
std::string doubt_of(const SolvedComponent& c, Index i) {
  const double limit = (c.verdict.all_shown ? 100 : 1) * solver_residual(c.spectrum.size()), residual = c.assessment.own_residual(i);
  return residual <= limit
             ? ""
             : fmt::format("the root at ω = {:.6g} has the residual {:.2g}, above {:.2g}", c.spectrum.omega(i), residual, limit);
}

}  // namespace

MatrixSpectrum::MatrixSpectrum(SolvedSystem solved) : solved_(std::move(solved)), at_zero_(solved_.negative_at_zero()) {
  for (const SolvedComponent& c : solved_.components) {
    const bool rigid = solved_.first_order || c.spectrum.stiffness_negative == 0;
    for (Index k = 0; k < c.spectrum.zero_pairs(); ++k) {
      roots_.push_back({0, 0, 0, true, rigid, ""});
      places_.push_back({&c, k});
    }
    for (Index k = 0; k < c.spectrum.omega.size(); ++k) {
      roots_.push_back(
          {c.spectrum.omega(k), open_error(c, k), c.verdict.energy_sign[static_cast<std::size_t>(k)], false, false, doubt_of(c, k)});
      places_.push_back({&c, k});
    }
  }
  sort();
}

void MatrixSpectrum::sort() {
  std::vector<std::size_t> order(roots_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t k) { return roots_[i].omega < roots_[k].omega; });
  std::vector<CountedRoot> roots;
  std::vector<Place> places;
  for (const std::size_t i : order) {
    roots.push_back(roots_[i]);
    places.push_back(places_[i]);
  }
  roots_ = std::move(roots);
  places_ = std::move(places);
}

RootRange MatrixSpectrum::roots(const Window&, const Progress&) const {
  return {roots_, [this](std::size_t root, bool with_shape) { return mode(root, with_shape); }};
}

// Where there is no root any frequency that has the unit of the system; M alone: every ω is as good.
double MatrixSpectrum::above_all() const {
  if (!roots_.empty() && roots_.back().omega > 0) return 1.125 * roots_.back().omega;
  double typical = 0;
  for (const SolvedComponent& c : solved_.components) typical = std::max(typical, c.impedance.typical_frequency());
  return typical > 0 ? typical : 1;
}

Index MatrixSpectrum::below(double omega) const {
  return std::count_if(roots_.begin(), roots_.end(), [&](const CountedRoot& r) { return !r.zero && r.omega < omega; });
}

Index MatrixSpectrum::missed_by_signs(const Window& range) const {
  Index missed = 0;
  for (const CountedRoot& r : roots_) {
    if (!r.zero && range.contains(r.omega)) missed += 1 - r.energy_sign;
  }
  return missed;
}

std::string MatrixSpectrum::open_reason() const {
  return (solved_.interrupted ? "" : "the index balance does not close: ") + solved_.open_reason();
}

// Beyond some order no factorisation is spent on gaps where Parseval's identity has shown that no root is listed twice:
// with as many as there must be none is missing then.
bool MatrixSpectrum::isolated() const {
  constexpr Index factorisations_cost = 64;
  return solved_.size > factorisations_cost && std::all_of(solved_.components.begin(), solved_.components.end(),
                                                           [](const SolvedComponent& c) { return c.assessment.no_root_twice; });
}

ComplexVector MatrixSpectrum::in_system(const SolvedComponent& c, const ComplexVector& part) const {
  ComplexVector x = ComplexVector::Zero(solved_.size);
  x(c.spectrum.order) = part;
  return x;
}

ComplexVector MatrixSpectrum::shape_of(const SolvedComponent& c, const ComplexVector& part) const { return normalised(in_system(c, part)); }

Mode MatrixSpectrum::mode(std::size_t root, bool with_shape) const {
  const auto& [c, position] = places_[root];
  Mode m;
  m.omega = roots_[root].omega;
  m.energy_sign = roots_[root].energy_sign;
  m.kind = roots_[root].rigid_body ? ModeKind::rigid_body : ModeKind::vibration;
  if (roots_[root].zero) {
    if (with_shape) m.shape = shape_of(*c, c->spectrum.zero_shapes.col(position).cast<Complex>());
    return m;
  }
  m.residual = c->assessment.residual(position);
  m.error_bound = c->assessment.error_bound(position);
  m.cluster = c->assessment.cluster[static_cast<std::size_t>(position)];
  if (with_shape) {
    const ComplexVector part = c->spectrum.shape(position);
    m.shape = shape_of(*c, part);
    m.form = c->assessment.form(position) / std::norm(largest_entry(part));
  }
  return m;
}

std::vector<Mode> MatrixSpectrum::oscillations() const {
  std::vector<Mode> all;
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    if (!roots_[i].zero) all.push_back(mode(i, true));
  }
  return all;
}

Matrix MatrixSpectrum::zero_shapes() const {
  std::vector<std::size_t> zeros;
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    if (roots_[i].zero) zeros.push_back(i);
  }
  Matrix all(solved_.size, static_cast<Index>(zeros.size()));
  for (Index k = 0; k < all.cols(); ++k) all.col(k) = mode(zeros[static_cast<std::size_t>(k)], true).shape.real();
  return all;
}

UnstableRoots MatrixSpectrum::unstable() const {
  UnstableRoots all;
  for (const SolvedComponent& c : solved_.components) {
    const UnstableRoots& u = c.spectrum.unstable;
    for (Index k = 0; k < u.count(); ++k)
      all.add(u.lambda[static_cast<std::size_t>(k)], in_system(c, u.right.col(k)), in_system(c, u.left.col(k)));
  }
  return all;
}

UnstableMode MatrixSpectrum::growing(const SolvedComponent& c, Index k, bool with_shape) const {
  const Complex lambda = c.spectrum.unstable.lambda[static_cast<std::size_t>(k)];
  UnstableMode u{lambda.real(), lambda.imag(), c.assessment.unstable.residual(k), c.assessment.unstable.error_bound(k), {}};
  if (with_shape) u.shape = shape_of(c, c.spectrum.unstable.right.col(k));
  return u;
}

void MatrixSpectrum::describe(ModesResult& r, bool with_shapes) const {
  r.structure = solved_.structure;
  r.stiffness = solved_.stiffness();
  r.solver = solved_.solver();
  r.coverage.interrupted = solved_.interrupted;
  r.first_order = solved_.first_order;
  r.stability = solved_.stability();
  r.opposite_gap = infinity;
  for (const SolvedComponent& c : solved_.components) {
    r.opposite_gap = std::min(r.opposite_gap, c.verdict.gap);
    for (Index k = 0; k < c.spectrum.unstable.count(); ++k) {
      if (c.verdict.unstable_shown[static_cast<std::size_t>(k)]) r.unstable.push_back(growing(c, k, with_shapes));
    }
  }
  for (std::size_t i = 0; i < roots_.size(); ++i) {
    if (!roots_[i].zero && roots_[i].energy_sign <= 0) r.negative_modes.push_back(mode(i, with_shapes));
  }
}

}  // namespace gyromode
