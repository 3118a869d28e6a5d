#include "gyromode/motion/response.h"

#include "gyromode/motion/component_motion.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gyromode {

namespace {

void require(const Vector& v, Index n, const char* what) {
  if (v.size() != n) throw std::invalid_argument(fmt::format("{}: {} numbers where the system has {} coordinates", what, v.size(), n));
  if (!v.allFinite()) throw std::invalid_argument(fmt::format("{}: not finite", what));
}

}  // namespace

Response::~Response() = default;
Response::Response(Response&&) noexcept = default;

Response::Response(const System& system, const State& initial, const std::vector<Force>& forces)
    : mass_(system.mass()), stiffness_(system.stiffness()) {
  const Index n = system.size();
  require(initial.q, n, "initial displacements");
  require(initial.qdot, n, "initial velocities");
  const Eigen::LLT<Matrix> mass(mass_);
  State start = initial;
  std::vector<Vector> lasting, accelerations;
  std::vector<double> frequencies;
  for (const Force& f : forces) {
    require(f.amplitude, n, "force");
    const Vector push = mass.solve(f.amplitude);
    if (f.course == Force::Course::impulse) {
      start.qdot += push;
    } else {
      lasting.push_back(f.amplitude);
      accelerations.push_back(push);
      frequencies.push_back(f.course == Force::Course::step ? 0 : f.frequency);
    }
  }
  start_ = start;
  const SolvedSystem solved = solve_components(system, dense::Method::automatic);
  stability_ = solved.stability();
  complete_ = solved.index_balance().closed;
  initial_energy_ = energy_of(start, mass_, stiffness_);
  double whole = 0, missing = 0;
  for (const SolvedComponent& component : solved.components) {
    parts_.push_back(std::make_unique<ComponentMotion>(system, component));
    ComponentMotion& part = *parts_.back();
    std::vector<Vector> own_forces, own_pushes;
    for (std::size_t k = 0; k < lasting.size(); ++k) {
      own_forces.push_back(lasting[k](part.order()));
      own_pushes.push_back(accelerations[k](part.order()));
    }
    part.start({start.q(part.order()), start.qdot(part.order())}, own_forces, own_pushes, frequencies);
    whole += part.size() * part.size();
    missing += part.departure() * part.departure();
    zero_energy_ += part.zero_energy();
    remainder_energy_ += part.remainder_energy();
    part.add_shares(n, modal_);
  }
  std::stable_sort(modal_.begin(), modal_.end(), [](const ModalShare& x, const ModalShare& y) { return x.omega < y.omega; });
  departure_ = whole > 0 ? std::sqrt(missing / whole) : 0;
}

State Response::at(double t) const {
  if (t == 0) return start_;
  State w{Vector::Zero(mass_.rows()), Vector::Zero(mass_.rows())};
  for (const auto& part : parts_) {
    const State own = part->at(t);
    w.q(part->order()) = own.q;
    w.qdot(part->order()) = own.qdot;
  }
  return w;
}

History Response::at(const Vector& times) const { return history_of(*this, mass_.rows(), times); }

double Response::energy(const State& w) const { return energy_of(w, mass_, stiffness_); }

Index Response::remainder_size() const {
  Index d = 0;
  for (const auto& part : parts_) d += part->remainder_size();
  return d;
}

}  // namespace gyromode
