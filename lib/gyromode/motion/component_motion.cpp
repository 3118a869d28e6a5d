#include "gyromode/motion/component_motion.h"

#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/motion/time_course.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

State minus(const State& a, const State& b) { return {a.q - b.q, a.qdot - b.qdot}; }
State plus(const State& a, const State& b) { return {a.q + b.q, a.qdot + b.qdot}; }

}  // namespace

double energy_of(const State& w, const Matrix& mass, const Matrix& stiffness) {
  return 0.5 * (w.qdot.dot(mass * w.qdot) + w.q.dot(stiffness * w.q));
}

ComponentMotion::ComponentMotion(const System& system, const SolvedComponent& c)
    : order_(c.spectrum.order),
      matrices_(system, order_),
      modal_(matrices_, c),
      zero_(matrices_, c.spectrum.zero_pairs()),
      norm_(matrices_, c),
      weights_(modal_.size()) {
  for (Index k = 0; k < modal_.size(); ++k) {
    const Vector re = modal_.shapes().col(k).real(), im = modal_.shapes().col(k).imag();
    weights_(k) = std::hypot(norm_({re, -modal_.omega()(k) * im}), norm_({im, modal_.omega()(k) * re}));
  }
}

Vector ComponentMotion::sizes_of_modes(const Split& s) const { return 2 * s.modes.cwiseAbs().cwiseProduct(weights_); }

// Projections repeated on what they leave: the vectors of a cluster need not be orthogonal to the last bit.
State ComponentMotion::project(const State& w, Split& s) const {
  constexpr int passes = 4;
  s.modes = ComplexVector::Zero(modal_.size());
  s.zero = Vector::Zero(zero_.size());
  State left = w;
  double before = infinity;
  for (int pass = 0; pass < passes; ++pass) {
    const ComplexVector more = modal_.amplitudes(matrices_, left);
    const Vector more_zero = zero_.coordinates(matrices_, left);
    State next = minus(minus(left, modal_.state(more)), zero_.state(more_zero));
    const double size = norm_(next);
    if (pass > 0 && !(size < 0.5 * before)) break;
    s.modes += more;
    s.zero += more_zero;
    left = std::move(next);
    before = size;
  }
  return left;
}

// What is left beside modes and zero roots is rounding, and no motion, up to 30 n ε of what it was left of.
Split ComponentMotion::split(const State& w) {
  const double n = static_cast<double>(order_.size());
  Split s;
  s.size = norm_(w);
  State left = project(w, s);
  double largest = std::max(s.size, norm_(zero_.state(s.zero)));
  for (const double size : sizes_of_modes(s)) largest = std::max(largest, size);
  const Index dimension = 2 * static_cast<Index>(order_.size()) - 2 * modal_.size() - zero_.size();
  double turned = 0;
  if (dimension > 0 && !(norm_(left) <= 30 * n * epsilon * largest)) {
    if (!rest_) rest_.emplace(matrices_, norm_, modal_, zero_, dimension);
    s.rest = rest_->coordinates(left);
    const State own = rest_->state(s.rest);
    left = minus(left, own);
    turned = rest_->departure() * norm_(own);
  }
  // What cancels in the sum at t = 0 does not cancel later: its rounding counts as missing.
  s.missing = std::max({norm_(left), turned, epsilon * largest});
  s.drift = drift_of(s);
  return s;
}

// Phases run away by the errors of the frequencies, those of modes with more than 10⁻⁶ of what was split: the others
// cannot spoil more than that.
double ComponentMotion::drift_of(const Split& s) const {
  constexpr double takes_part = 1e-6;
  const Vector sizes = sizes_of_modes(s);
  double most = 0;
  for (Index k = 0; k < sizes.size(); ++k) {
    if (sizes(k) > takes_part * s.size) most = std::max(most, modal_.error()(k));
  }
  if (s.rest.size() > 0 && norm_(rest_->state(s.rest)) > takes_part * s.size) most = std::max(most, rest_->rate_error());
  return most;
}

void ComponentMotion::start(const State& w, const std::vector<Vector>& pushes, const std::vector<double>& frequencies) {
  splits_.assign(1, split(w));
  frequencies_ = frequencies;
  for (std::size_t k = 0; k < pushes.size(); ++k) {
    splits_.push_back(split({Vector::Zero(pushes[k].size()), pushes[k]}));
    if (splits_.back().size > 0) splits_.back().drift = std::max(splits_.back().drift, epsilon * frequencies[k]);
  }
}

State ComponentMotion::at(double t) const {
  const Split& first = splits_.front();
  ComplexVector a(modal_.size());
  for (Index k = 0; k < a.size(); ++k) {
    a(k) = first.modes(k) * std::polar(1.0, modal_.omega()(k) * t);
    for (std::size_t i = 0; i < frequencies_.size(); ++i) a(k) += splits_[i + 1].modes(k) * forced(modal_.omega()(k), frequencies_[i], t);
  }
  State w = modal_.state(a);
  if (zero_.size() > 0) {
    Vector y = zero_.moved(first.zero, t);
    for (std::size_t i = 0; i < frequencies_.size(); ++i) y += zero_.driven(splits_[i + 1].zero, frequencies_[i], t);
    w = plus(w, zero_.state(y));
  }
  if (rest_) {
    Vector y = Vector::Zero(rest_->size());
    if (first.rest.size() > 0) y += rest_->moved(first.rest, t);
    for (std::size_t i = 0; i < frequencies_.size(); ++i) {
      if (splits_[i + 1].rest.size() > 0) y += rest_->driven(splits_[i + 1].rest, frequencies_[i], t);
    }
    w = plus(w, rest_->state(y));
  }
  return w;
}

void ComponentMotion::add_shares(const Vector& scale, std::vector<ModalShare>& to) const {
  const ComplexVector& a = splits_.front().modes;
  for (Index k = 0; k < modal_.size(); ++k) {
    ComplexVector shape = ComplexVector::Zero(scale.size());
    shape(order_) = modal_.shapes().col(k);
    shape = shape.cwiseProduct(scale.cast<Complex>()).eval();
    const Complex factor = 2.0 * a(k) * largest_entry(shape);
    const double form = modal_.form()(k), amplitude = std::abs(factor);
    to.push_back({modal_.omega()(k), amplitude, amplitude > 0 ? std::arg(factor) + 0.0 : 0, modal_.omega()(k) * form * std::norm(a(k)),
                  form > 0 ? 1 : -1, normalised(std::move(shape))});
  }
}

double ComponentMotion::zero_energy() const { return energy_of(zero_.state(splits_.front().zero), matrices_.mass, matrices_.stiffness); }

double ComponentMotion::remainder_energy() const {
  const Vector& y = splits_.front().rest;
  return y.size() > 0 ? energy_of(rest_->state(y), matrices_.mass, matrices_.stiffness) : 0;
}

}  // namespace gyromode
