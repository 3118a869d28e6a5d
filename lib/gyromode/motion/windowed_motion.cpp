#include "gyromode/motion/windowed_motion.h"

#include "gyromode/base/error.h"
#include "gyromode/motion/history.h"
#include "gyromode/motion/steady_solver.h"
#include "gyromode/motion/time_course.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/blas_threads.h"
#include "gyromode/sparse/matrix.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Of columns in the coordinates given.
Vector required(const SparseSystem& s, const Vector& v, std::string_view what) {
  require_coordinates(v, s.size(), what);
  return sparse::from_given(s, v).col(0);
}

ModesResult windowed_modes(const SparseSystem& s, ModesOptions options) {
  options.shapes = true;
  ModesResult found = find_modes(s, options);
  if (found.coverage.interrupted) throw Interrupted();
  if (found.stability == Stability::unstable)
    throw NotApplicable("the motion of a large model in the modes of a window is that of undamped ones, and this model is unstable");
  return found;
}

double energy_in(const SparseSystem& s, const State& w) {
  return 0.5 * (w.qdot.dot(sparse::symmetric_times(s.mass(), w.qdot).col(0)) + w.q.dot(sparse::symmetric_times(s.stiffness(), w.q).col(0)));
}

// r of Re(r e^{jνt}), what the force does beyond the modes: H(ν) is near to singular at one of them, which it does not
// drive.
ComplexVector steady_beyond(const SteadySolver& solver, const WindowedPart& part, const Vector& force, const ComplexVector& h, double nu) {
  constexpr double near = 1e-7;
  const auto solved = [&](double at) { return part.without_modes(solver.at(at, part.beyond(force, h, at)), h, at); };
  if (nu == 0) return solved(0).real().cast<Complex>();
  bool beside = false;
  for (const double omega : part.omega()) beside = beside || std::abs(nu - omega) <= near * omega;
  return beside ? ComplexVector(0.5 * (solved(nu * (1 + 2 * near)) + solved(nu * (1 - 2 * near)))) : solved(nu);
}

}  // namespace

WindowedMotion::WindowedMotion(const SparseSystem& system, const State& initial, const std::vector<Force>& forces, ModesOptions modes,
                               const std::vector<Index>& chosen)
    : found_(windowed_modes(system, std::move(modes))), part_(system, found_) {
  const auto threads = sparse::few_blas_threads(system.size());
  const SteadySolver solver(system);
  const auto seen = [&](const ComplexVector& q) { return chosen.empty() ? q : ComplexVector(q(chosen)); };
  shapes_.resize(chosen.empty() ? system.size() : static_cast<Index>(chosen.size()), part_.size());
  for (Index k = 0; k < part_.size(); ++k)
    shapes_.col(k) = seen(found_.modes[static_cast<std::size_t>(part_.which()[static_cast<std::size_t>(k)])].shape);
  State w{required(system, initial.q, "initial displacements"), required(system, initial.qdot, "initial velocities")};
  const bool free = system.translations().cols() > 0 || found_.index_balance.zero > 0;
  for (const Force& f : forces) {
    const Vector amplitude = required(system, f.amplitude, "force");
    if (f.course == Force::Course::impulse) {
      w.qdot += solver.accelerations(amplitude);
      continue;
    }
    const double nu = f.course == Force::Course::step ? 0 : f.frequency;
    const WindowedPart::Share share = part_.share_of(Vector::Zero(system.size()), amplitude);
    const double pushed = solver.size_of(amplitude) * std::sqrt(0.5);  // the root of the energy of (0, M⁻¹f)
    if (pushed > 0) departure_ = std::max(departure_, share.missing / pushed);
    Lasting one{nu, share.amplitudes, {}};
    if (free && nu == 0)
      free_under_steps_ = true;
    else
      one.remainder = seen(sparse::in_given(system, steady_beyond(solver, part_, amplitude, one.modes, nu)));
    lasting_.push_back(std::move(one));
  }
  start(system, w);
}

// Modes are orthogonal in the energy: what is left of it is that of the others.
void WindowedMotion::start(const SparseSystem& system, const State& w) {
  const WindowedPart::Share share = part_.share_of(w.q, sparse::symmetric_times(system.mass(), w.qdot).col(0));
  started_ = share.amplitudes;
  initial_energy_ = energy_in(system, w);
  const State own = part_.state(started_);
  left_out_ = energy_in(system, {w.q - own.q, w.qdot - own.qdot});
  const double whole = std::hypot(share.size, std::sqrt(std::abs(left_out_)));
  if (whole > 0) departure_ = std::max(departure_, share.missing / whole);
  for (Index k = 0; k < part_.size(); ++k) {
    constexpr double takes_part = 1e-6;
    bool moves = std::sqrt(part_.omega()(k) * std::abs(part_.form()(k))) * std::abs(started_(k)) > takes_part * whole;
    for (const Lasting& f : lasting_) moves = moves || std::abs(f.modes(k)) > 0;
    if (moves) phase_drift_ = std::max(phase_drift_, part_.error()(k));
    const Mode& mode = found_.modes[static_cast<std::size_t>(part_.which()[static_cast<std::size_t>(k)])];
    const Complex a = started_(k);
    modal_.push_back({part_.omega()(k), 2 * std::abs(a), std::abs(a) > 0 ? std::arg(a) : 0,
                      part_.omega()(k) * part_.form()(k) * std::norm(a), mode.energy_sign, shapes_.col(k)});
  }
  found_.drop_shapes();
}

bool WindowedMotion::with_steady_parts() const {
  return std::any_of(lasting_.begin(), lasting_.end(), [](const Lasting& f) { return f.remainder.size() > 0; });
}

State WindowedMotion::at(double t) const {
  require_time(t);
  const Complex j(0, 1);
  ComplexVector a(part_.size()), rate(part_.size());
  for (Index k = 0; k < a.size(); ++k) {
    const double omega = part_.omega()(k);
    a(k) = started_(k) * std::polar(1.0, omega * t);
    Complex push = 0;
    for (const Lasting& f : lasting_) {
      a(k) += f.modes(k) * forced(omega, f.frequency, t);
      push += f.modes(k) * std::cos(f.frequency * t);
    }
    rate(k) = j * omega * a(k) + push;
  }
  State w{2 * (shapes_ * a).real(), 2 * (shapes_ * rate).real()};
  for (const Lasting& f : lasting_) {
    if (f.remainder.size() == 0) continue;
    const ComplexVector r = f.remainder * std::polar(1.0, f.frequency * t);
    w.q += r.real();
    w.qdot += (j * f.frequency * r).real();
  }
  return w;
}

History WindowedMotion::at(const Vector& times, const Progress& progress) const {
  return history_of(*this, shapes_.rows(), times, progress);
}

}  // namespace gyromode
