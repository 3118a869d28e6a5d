#include "gyromode/motion/response.h"

#include "gyromode/modes/shape.h"
#include "gyromode/motion/modal_part.h"
#include "gyromode/motion/remainder.h"
#include "gyromode/motion/time_course.h"
#include "gyromode/motion/zero_part.h"

#include <Eigen/Cholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gyromode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// A force on the coordinates of a part that acts on after t = 0.
struct Drive {
  ComplexVector on_modes;
  Vector on_zero, on_remainder;
  double nu = 0;
};

State minus(State a, const State& b) { return {a.q - b.q, a.qdot - b.qdot}; }
State plus(State a, const State& b) { return {a.q + b.q, a.qdot + b.qdot}; }

void require(const Vector& v, Index n, const char* what) {
  if (v.size() != n) throw std::invalid_argument(fmt::format("{}: {} numbers where the system has {} coordinates", what, v.size(), n));
  if (!v.allFinite()) throw std::invalid_argument(fmt::format("{}: not finite", what));
}

double size_of(const State& w, const Matrix& mass, double omega) { return std::sqrt(w.qdot.dot(mass * w.qdot) + omega * omega * w.q.dot(mass * w.q)); }

double energy_of(const State& w, const Matrix& mass, const Matrix& stiffness) { return 0.5 * (w.qdot.dot(mass * w.qdot) + w.q.dot(stiffness * w.q)); }

}  // namespace

// One connected component.
struct Response::Part {
  std::vector<Index> order;
  ComponentMatrices matrices;
  ModalPart modal;
  ZeroPart zero;
  std::optional<Remainder> rest;
  ComplexVector a;       // of the modes at t = 0
  Vector zero_start, rest_start;
  std::vector<Drive> drives;
  double unit = 1;       // a frequency of the size of the largest
  double departure = 0;  // absolute, of the sum at t = 0

  Part(const System& system, const SolvedComponent& c)
      : order(c.spectrum.order), matrices(system, order), modal(matrices, c), zero(matrices, c.spectrum.zero_pairs()), unit(c.impedance.typical_frequency()) {}

  // Projections repeated on what they leave: the vectors of a cluster need not be orthogonal to the last bit.
  State start(const State& w) {
    a = ComplexVector::Zero(modal.size());
    zero_start = Vector::Zero(zero.size());
    State left = w;
    double before = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < 4; ++pass) {
      const ComplexVector more = modal.amplitudes(matrices, left);
      const Vector more_zero = zero.coordinates(matrices, left);
      State next = minus(minus(left, modal.state(more)), zero.state(more_zero));
      const double size = size_of(next, matrices.mass, unit);
      if (pass > 0 && !(size < 0.5 * before)) break;
      a += more;
      zero_start += more_zero;
      left = std::move(next);
      before = size;
    }
    return left;
  }

  // What is neither in modes nor at zero, and what steady forces (accelerations M⁻¹f) push that way.
  void follow_rest(const State& left, double size, const std::vector<Vector>& pushes) {
    const double n = static_cast<double>(order.size());
    const bool rounding = size_of(left, matrices.mass, unit) <= 30 * n * epsilon * size;
    const Index dimension = 2 * static_cast<Index>(order.size()) - 2 * modal.size() - zero.size();
    std::vector<State> starts;
    if (!rounding) starts.push_back(left);
    for (const Vector& push : pushes) starts.push_back({Vector::Zero(push.size()), push});
    if (dimension > 0 && !starts.empty()) {
      rest.emplace(matrices, modal, zero, dimension, unit, starts);
      rest_start = rounding ? Vector(Vector::Zero(rest->size())) : rest->coordinates(left);
    }
    departure = size_of(rest ? minus(left, rest->state(rest_start)) : left, matrices.mass, unit);
  }

  void drive(const Vector& force, const Vector& push, double nu) {
    Drive d{modal.excitation(force), zero.excitation(force), Vector(0), nu};
    if (rest) d.on_remainder = rest->coordinates(stripped(matrices, modal, zero, {Vector::Zero(push.size()), push}));
    drives.push_back(std::move(d));
  }

  void add_shares(Index n, std::vector<ModalShare>& to) const {
    for (Index k = 0; k < modal.size(); ++k) {
      ComplexVector shape = ComplexVector::Zero(n);
      shape(order) = modal.shapes().col(k);
      const Complex factor = 2.0 * a(k) * largest_entry(shape);
      const double form = modal.form()(k);
      to.push_back({modal.omega()(k), std::abs(factor), std::abs(factor) > 0 ? std::arg(factor) : 0, modal.omega()(k) * form * std::norm(a(k)), form > 0 ? 1 : -1,
                    normalised(std::move(shape))});
    }
  }

  State at(double t) const {
    ComplexVector now(a.size());
    for (Index k = 0; k < a.size(); ++k) {
      now(k) = a(k) * std::polar(1.0, modal.omega()(k) * t);
      for (const Drive& d : drives) now(k) += d.on_modes(k) * forced(modal.omega()(k), d.nu, t);
    }
    State w = modal.state(now);
    if (zero.size() > 0) {
      Vector y = zero.moved(zero_start, t);
      for (const Drive& d : drives) y += zero.driven(d.on_zero, d.nu, t);
      w = plus(std::move(w), zero.state(y));
    }
    if (rest && rest->size() > 0) {
      Vector y = rest->moved(rest_start, t);
      for (const Drive& d : drives) y += rest->driven(d.on_remainder, d.nu, t);
      w = plus(std::move(w), rest->state(y));
    }
    return w;
  }
};

Response::~Response() = default;
Response::Response(Response&&) noexcept = default;

Response::Response(const System& system, const State& initial, const std::vector<Force>& forces, const StructureOptions& structure)
    : mass_(system.mass()), stiffness_(system.stiffness()) {
  const Index n = system.size();
  require(initial.q, n, "initial displacements");
  require(initial.qdot, n, "initial velocities");
  const Eigen::LLT<Matrix> mass(mass_);
  State start = initial;
  std::vector<Force> lasting;
  std::vector<Vector> accelerations;
  for (const Force& f : forces) {
    require(f.amplitude, n, "force");
    const Vector push = mass.solve(f.amplitude);
    if (f.course == Force::Course::impulse) {
      start.qdot += push;
    } else {
      lasting.push_back(f);
      accelerations.push_back(push);
    }
  }
  start_ = start;
  const SolvedSystem solved = solve_components(system, structure, dense::Method::automatic);
  stability_ = solved.stability();
  complete_ = solved.index_balance().closed;
  initial_energy_ = energy_of(start, mass_, stiffness_);
  double whole = 0, missing = 0;
  for (const SolvedComponent& c : solved.components) {
    parts_.push_back(std::make_unique<Part>(system, c));
    Part& part = *parts_.back();
    const State w{start.q(part.order), start.qdot(part.order)};
    const double size = size_of(w, part.matrices.mass, part.unit);
    const State left = part.start(w);
    std::vector<Vector> pushes;
    for (const Vector& push : accelerations) pushes.push_back(push(part.order));
    part.follow_rest(left, size, pushes);
    for (std::size_t k = 0; k < lasting.size(); ++k) {
      part.drive(lasting[k].amplitude(part.order), pushes[k], lasting[k].course == Force::Course::step ? 0 : lasting[k].frequency);
    }
    whole += size * size;
    missing += part.departure * part.departure;
    zero_energy_ += energy_of(part.zero.state(part.zero_start), part.matrices.mass, part.matrices.stiffness);
    if (part.rest) remainder_energy_ += energy_of(part.rest->state(part.rest_start), part.matrices.mass, part.matrices.stiffness);
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
    w.q(part->order) = own.q;
    w.qdot(part->order) = own.qdot;
  }
  return w;
}

History Response::at(const Vector& times) const {
  History h{times, Matrix(mass_.rows(), times.size()), Matrix(mass_.rows(), times.size())};
  for (Index k = 0; k < times.size(); ++k) {
    const State w = at(times(k));
    h.q.col(k) = w.q;
    h.qdot.col(k) = w.qdot;
  }
  return h;
}

double Response::energy(const State& w) const { return energy_of(w, mass_, stiffness_); }

Index Response::remainder_size() const {
  Index d = 0;
  for (const auto& part : parts_) d += part->rest ? part->rest->size() : 0;
  return d;
}

}  // namespace gyromode
