#include "gyromode/motion/component_motion.h"

#include "gyromode/modes/shape.h"
#include "gyromode/motion/time_course.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

State minus(State a, const State& b) { return {a.q - b.q, a.qdot - b.qdot}; }
State plus(State a, const State& b) { return {a.q + b.q, a.qdot + b.qdot}; }

}  // namespace

double energy_of(const State& w, const Matrix& mass, const Matrix& stiffness) { return 0.5 * (w.qdot.dot(mass * w.qdot) + w.q.dot(stiffness * w.q)); }

ComponentMotion::ComponentMotion(const System& system, const SolvedComponent& c)
    : order_(c.spectrum.order), matrices_(system, order_), modal_(matrices_, c), zero_(matrices_, c.spectrum.zero_pairs()), unit_(c.impedance.typical_frequency() / c.impedance.units().time) {}

double ComponentMotion::norm(const State& w) const { return std::sqrt(w.qdot.dot(matrices_.mass * w.qdot) + unit_ * unit_ * w.q.dot(matrices_.mass * w.q)); }

// Projections repeated on what they leave: the vectors of a cluster need not be orthogonal to the last bit.
State ComponentMotion::project(const State& w) {
  constexpr int passes = 4;
  a_ = ComplexVector::Zero(modal_.size());
  zero_start_ = Vector::Zero(zero_.size());
  State left = w;
  double before = std::numeric_limits<double>::infinity();
  for (int pass = 0; pass < passes; ++pass) {
    const ComplexVector more = modal_.amplitudes(matrices_, left);
    const Vector more_zero = zero_.coordinates(matrices_, left);
    State next = minus(minus(left, modal_.state(more)), zero_.state(more_zero));
    const double size = norm(next);
    if (pass > 0 && !(size < 0.5 * before)) break;
    a_ += more;
    zero_start_ += more_zero;
    left = std::move(next);
    before = size;
  }
  return left;
}

// What is neither in modes nor at zero, and what lasting forces push that way.
void ComponentMotion::follow_rest(const State& left, const std::vector<Vector>& pushes) {
  const double n = static_cast<double>(order_.size());
  const bool rounding = norm(left) <= 30 * n * epsilon * size_;
  const Index dimension = 2 * static_cast<Index>(order_.size()) - 2 * modal_.size() - zero_.size();
  std::vector<State> starts;
  if (!rounding) starts.push_back(left);
  for (const Vector& push : pushes) starts.push_back({Vector::Zero(push.size()), push});
  if (dimension > 0 && !starts.empty()) {
    rest_.emplace(matrices_, modal_, zero_, dimension, unit_, starts);
    rest_start_ = rounding ? Vector(Vector::Zero(rest_->size())) : rest_->coordinates(left);
  }
  // What cancels in the sum at t = 0 does not cancel later: its rounding counts as a departure.
  double largest = 0;
  for (Index k = 0; k < a_.size(); ++k) {
    ComplexVector one = ComplexVector::Zero(a_.size());
    one(k) = a_(k);
    largest = std::max(largest, norm(modal_.state(one)));
  }
  departure_ = std::max(norm(rest_ ? minus(left, rest_->state(rest_start_)) : left), epsilon * largest);
}

void ComponentMotion::start(const State& w, const std::vector<Vector>& forces, const std::vector<Vector>& pushes, const std::vector<double>& frequencies) {
  size_ = norm(w);
  follow_rest(project(w), pushes);
  for (std::size_t k = 0; k < forces.size(); ++k) {
    Drive d{modal_.excitation(forces[k]), zero_.excitation(forces[k]), Vector(0), frequencies[k]};
    if (rest_) d.on_remainder = rest_->coordinates(stripped(matrices_, modal_, zero_, {Vector::Zero(pushes[k].size()), pushes[k]}));
    drives_.push_back(std::move(d));
  }
}

State ComponentMotion::at(double t) const {
  ComplexVector now(a_.size());
  for (Index k = 0; k < a_.size(); ++k) {
    now(k) = a_(k) * std::polar(1.0, modal_.omega()(k) * t);
    for (const Drive& d : drives_) now(k) += d.on_modes(k) * forced(modal_.omega()(k), d.nu, t);
  }
  State w = modal_.state(now);
  if (zero_.size() > 0) {
    Vector y = zero_.moved(zero_start_, t);
    for (const Drive& d : drives_) y += zero_.driven(d.on_zero, d.nu, t);
    w = plus(std::move(w), zero_.state(y));
  }
  if (rest_ && rest_->size() > 0) {
    Vector y = rest_->moved(rest_start_, t);
    for (const Drive& d : drives_) y += rest_->driven(d.on_remainder, d.nu, t);
    w = plus(std::move(w), rest_->state(y));
  }
  return w;
}

void ComponentMotion::add_shares(Index n, std::vector<ModalShare>& to) const {
  for (Index k = 0; k < modal_.size(); ++k) {
    ComplexVector shape = ComplexVector::Zero(n);
    shape(order_) = modal_.shapes().col(k);
    const Complex factor = 2.0 * a_(k) * largest_entry(shape);
    const double form = modal_.form()(k), amplitude = std::abs(factor);
    to.push_back({modal_.omega()(k), amplitude, amplitude > 0 ? std::arg(factor) + 0.0 : 0, modal_.omega()(k) * form * std::norm(a_(k)), form > 0 ? 1 : -1, normalised(std::move(shape))});
  }
}

double ComponentMotion::zero_energy() const { return energy_of(zero_.state(zero_start_), matrices_.mass, matrices_.stiffness); }
double ComponentMotion::remainder_energy() const { return rest_ ? energy_of(rest_->state(rest_start_), matrices_.mass, matrices_.stiffness) : 0; }

}  // namespace gyromode
