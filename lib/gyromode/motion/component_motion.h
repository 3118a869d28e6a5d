#pragma once

#include "gyromode/motion/energy_norm.h"
#include "gyromode/motion/modal_part.h"
#include "gyromode/motion/remainder.h"
#include "gyromode/motion/response.h"
#include "gyromode/motion/zero_part.h"

#include <optional>
#include <vector>

namespace gyromode {

/// What sets a component in motion, an initial state or the accelerations of a force, in the three parts of its motion.
/// Sizes are in the EnergyNorm: rounding is what is small beside the size of what was split, or beside the largest of
/// its parts.
struct Split {
  ComplexVector modes;  ///< amplitudes a
  Vector zero;          ///< coordinates of the ZeroPart
  Vector rest;          ///< of the Remainder; empty where there is none
  double size = 0;      ///< of what was split
  double missing = 0;   ///< of what the parts do not add up to, now or a little later
  double drift = 0;     ///< rad per unit of time: by how much the phase of a mode that takes part may run away, to first order
};

/// The motion of one connected component in its three parts.
class ComponentMotion {
 public:
  /// Of a system with unit masses.
  ComponentMotion(const System& system, const SolvedComponent& c);
  ComponentMotion(const ComponentMotion&) = delete;
  ComponentMotion& operator=(const ComponentMotion&) = delete;

  /// Takes the state apart, then what lasting forces push: accelerations `pushes[k]` = M⁻¹f with the course
  /// cos(frequencies[k] · t), in the order of the component.
  void start(const State& w, const std::vector<Vector>& pushes, const std::vector<double>& frequencies);

  const std::vector<Index>& order() const { return order_; }
  State at(double t) const;
  /// Shapes in coordinates q = scale · q̂.
  void add_shares(const Vector& scale, std::vector<ModalShare>& to) const;
  double zero_energy() const;
  double remainder_energy() const;
  Index remainder_size() const { return rest_ ? rest_->size() : 0; }
  /// The initial state, then each lasting force.
  const std::vector<Split>& splits() const { return splits_; }

 private:
  Vector sizes_of_modes(const Split& s) const;
  State project(const State& w, Split& s) const;
  Split split(const State& w);
  double drift_of(const Split& s) const;

  std::vector<Index> order_;
  ComponentMatrices matrices_;
  ModalPart modal_;
  ZeroPart zero_;
  EnergyNorm norm_;
  Vector weights_;  // of the modes: the length of (X, jωX) in the norm
  std::optional<Remainder> rest_;
  std::vector<Split> splits_;
  std::vector<double> frequencies_;  // ν of splits_[k + 1]
};

/// ½q̇ᵀMq̇ + ½qᵀKq.
double energy_of(const State& w, const Matrix& mass, const Matrix& stiffness);

}  // namespace gyromode
