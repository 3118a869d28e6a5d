#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/motion/response.h"
#include "gyromode/motion/windowed_part.h"

namespace gyromode {

/// The motion of a sparse system from given q(0), q̇(0) and under forces, in its modes of a window; of what lasting
/// forces do beyond them the steady part (residual flexibility). What is left out is stated.
class WindowedMotion {
 public:
  /// `modes`: the window, or how many lowest ones. `chosen`: the coordinates that at() gives; empty: all.
  /// @throws InvalidArgument where sizes do not fit or a number is not finite; NotApplicable where the system is
  /// unstable, or for an impulse where M is singular; and what find_modes() throws
  WindowedMotion(const SparseSystem& system, const State& initial, const std::vector<Force>& forces, ModesOptions modes,
                 const std::vector<Index>& chosen);

  /// Of the chosen coordinates; velocities are the derivatives of the displacements.
  State at(double t) const;
  /// At many times, ≥ 0; `progress` is told "times".
  History at(const Vector& times, const Progress& progress = {}) const;

  const std::vector<ModalShare>& modal() const { return modal_; }  ///< of the motion that starts, ascending in ω
  const ModesResult& modes() const { return found_; }              ///< without shapes
  double initial_energy() const { return initial_energy_; }        ///< ½q̇ᵀMq̇ + ½qᵀKq at t = 0⁺
  /// Of it, what is in no mode of the window, to rounding of all of it.
  double energy_left_out() const { return left_out_; }
  /// What is still in the modes of the initial state, and of what lasting forces push, after it was taken out,
  /// relative: the accuracy of the decomposition.
  double departure() const { return departure_; }
  /// rad: error bounds of the frequencies of modes with more than 10⁻⁶ of the motion, times t.
  double phase_error(double t) const { return phase_drift_ * t; }
  /// Whether a lasting force has a steady part beyond the modes, which is there from t = 0 on.
  bool with_steady_parts() const;
  /// Whether a step has none: the body is free.
  bool free_under_steps() const { return free_under_steps_; }

 private:
  struct Lasting {
    double frequency = 0;     // ν
    ComplexVector modes;      // h: ȧ = jωa + h cos νt
    ComplexVector remainder;  // r of Re(r e^{jνt}), of the chosen coordinates; empty where there is none
  };
  void start(const SparseSystem& system, const State& w);

  ModesResult found_;
  WindowedPart part_;
  ComplexMatrix shapes_;  // of the chosen coordinates
  ComplexVector started_;
  std::vector<Lasting> lasting_;
  std::vector<ModalShare> modal_;
  double initial_energy_ = 0, left_out_ = 0, departure_ = 0, phase_drift_ = 0;
  bool free_under_steps_ = false;
};

}  // namespace gyromode
