#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/motion/state.h"
#include "gyromode/spectrum/verdict.h"
#include "gyromode/system/system.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gyromode {

class ComponentMotion;
struct UnitMasses;

/// One undamped mode's share of a motion: q_s(t) = amplitude · Re(X e^{j(ωt + phase)}) (Boland & Janssens 1979, Eq. 7).
struct ModalShare {
  double omega = 0;      ///< rad per unit of time
  double amplitude = 0;  ///< ≥ 0, of the coordinate whose entry in X is 1
  double phase = 0;      ///< rad, in (−π, π]
  double energy = 0;     ///< of its own: their sum is the energy of all modes (negative for a mode of negative energy)
  int energy_sign = 1;   ///< of the mode
  ComplexVector shape;   ///< X, n, largest entry 1
};

/// Displacements and velocities over time: n × (number of times).
struct History {
  Vector t;                  ///< times, ascending
  Matrix q;                  ///< displacements
  Matrix qdot;               ///< velocities
  bool interrupted = false;  ///< work was stopped: the times that were asked for beyond the last are left out
};
/// The motion of M q̈ + G q̇ + K q = Σ f u(t) from given q(0), q̇(0), at any time t ≥ 0 without stepping: simple undamped
/// modes as such, zero roots as displaced rest and steady drift, exactly linear in t; growing motions and double roots
/// by the exponential on their own invariant subspace.
class Response {
 public:
  /// Throws InvalidArgument where sizes do not fit or a number is not finite, and what the modes throw.
  Response(const System& system, const State& initial, const std::vector<Force>& forces = {});
  ~Response();
  Response(Response&&) noexcept;  ///< movable

  /// At one time. Throws InvalidArgument unless t ≥ 0 and finite: forces begin at 0.
  State at(double t) const;
  /// At many times, ≥ 0; `progress` is told "times".
  History at(const Vector& times, const Progress& progress = {}) const;

  /// Of the motion that starts at t = 0⁺ (impulses included), ascending in ω; without steps and harmonic forces.
  const std::vector<ModalShare>& modal() const { return modal_; }
  /// ½q̇ᵀMq̇ + ½qᵀKq.
  double energy(const State& w) const;
  double initial_energy() const { return initial_energy_; }  ///< at t = 0⁺
  /// Of displaced rest and drift, and of what neither modes nor zero roots hold.
  double zero_energy() const { return zero_energy_; }
  double remainder_energy() const { return remainder_energy_; }  ///< of growing motions and double roots
  /// Coordinates of the invariant subspace of growing motions and double roots that take part; 0 for an ordinary stable
  /// motion.
  Index remainder_size() const;
  /// ‖sum of all parts at t = 0 less the initial state‖, or the rounding of the largest part if that is more, over the
  /// size of the state, in units that mix nothing; the same of what every lasting force pushes; the largest of them:
  /// the accuracy of the decomposition.
  double departure() const { return departure_; }
  /// rad: what the phases of the modes that take part may be wrong by at time t, the error bounds of their frequencies
  /// times t, to first order.
  double phase_error(double t) const { return phase_drift_ * t; }
  Stability stability() const { return stability_; }  ///< of the system
  /// The index balance closes (theory §5): the solver's roots account for all 2n and for n₋(K). Nothing is counted a
  /// second time, by factorisations, as `modes` does.
  bool balance_closed() const { return balance_closed_; }

 private:
  State in_units(const State& w) const;
  void judge(std::size_t split);

  std::vector<std::unique_ptr<ComponentMotion>> parts_;
  std::vector<ModalShare> modal_;
  std::unique_ptr<const UnitMasses> units_;
  State start_;  // at t = 0⁺, in the given coordinates
  double initial_energy_ = 0, zero_energy_ = 0, remainder_energy_ = 0, departure_ = 0, phase_drift_ = 0;
  Stability stability_ = Stability::unknown;
  bool balance_closed_ = false;
};

}  // namespace gyromode
