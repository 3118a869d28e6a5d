#include "gyromode/motion/response.h"

#include "gyromode/lapack/triangular.h"
#include "gyromode/motion/component_motion.h"
#include "gyromode/motion/history.h"
#include "gyromode/motion/unit_masses.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

Response::~Response() = default;
Response::Response(Response&&) noexcept = default;

Response::Response(const System& system, const State& initial, const std::vector<Force>& forces)
    : units_(std::make_unique<const UnitMasses>(with_unit_masses(system))), start_(initial) {
  const Index n = system.size();
  require_coordinates(initial.q, n, "initial displacements");
  require_coordinates(initial.qdot, n, "initial velocities");
  const lapack::Cholesky mass(units_->system.mass());
  State start = in_units(initial);
  std::vector<Vector> pushes;
  std::vector<double> frequencies;
  for (const Force& f : forces) {
    require_coordinates(f.amplitude, n, "force");
    const Vector push = mass.solve(units_->scale.cwiseProduct(f.amplitude));
    if (f.course == Force::Course::impulse) {
      start.qdot += push;
      start_.qdot += units_->scale.cwiseProduct(push);
    } else {
      pushes.push_back(push);
      frequencies.push_back(f.course == Force::Course::step ? 0 : f.frequency);
    }
  }
  const SolvedSystem solved = solve_components(units_->system, Method::automatic);
  stability_ = solved.stability();
  balance_closed_ = solved.index_balance().closed;
  initial_energy_ = energy_of(start, units_->system.mass(), units_->system.stiffness());
  for (const SolvedComponent& component : solved.components) {
    parts_.push_back(std::make_unique<ComponentMotion>(units_->system, component));
    ComponentMotion& part = *parts_.back();
    std::vector<Vector> own;
    for (const Vector& push : pushes) own.push_back(push(part.order()));
    part.start({start.q(part.order()), start.qdot(part.order())}, own, frequencies);
    zero_energy_ += part.zero_energy();
    remainder_energy_ += part.remainder_energy();
    part.add_shares(units_->scale, modal_);
  }
  std::stable_sort(modal_.begin(), modal_.end(), [](const ModalShare& x, const ModalShare& y) { return x.omega < y.omega; });
  for (std::size_t k = 0; k <= pushes.size(); ++k) judge(k);
}

State Response::in_units(const State& w) const { return {w.q.cwiseQuotient(units_->scale), w.qdot.cwiseQuotient(units_->scale)}; }

// The initial state, k = 0, or a lasting force.
void Response::judge(std::size_t k) {
  double whole = 0, missing = 0;
  for (const auto& part : parts_) {
    const Split& s = part->splits()[k];
    whole = std::hypot(whole, s.size);
    missing = std::hypot(missing, s.missing);
    phase_drift_ = std::max(phase_drift_, s.drift);
  }
  if (whole > 0) departure_ = std::max(departure_, missing / whole);
}

State Response::at(double t) const {
  require_time(t);
  if (t == 0) return start_;
  const Index n = units_->scale.size();
  State w = State::rest(n);
  for (const auto& part : parts_) {
    const State own = part->at(t);
    w.q(part->order()) = own.q;
    w.qdot(part->order()) = own.qdot;
  }
  return {w.q.cwiseProduct(units_->scale), w.qdot.cwiseProduct(units_->scale)};
}

History Response::at(const Vector& times, const Progress& progress) const {
  return history_of(*this, units_->scale.size(), times, progress);
}

double Response::energy(const State& w) const { return energy_of(in_units(w), units_->system.mass(), units_->system.stiffness()); }

Index Response::remainder_size() const {
  Index d = 0;
  for (const auto& part : parts_) d += part->remainder_size();
  return d;
}

}  // namespace gyromode
