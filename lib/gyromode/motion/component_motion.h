#pragma once

#include "gyromode/motion/modal_part.h"
#include "gyromode/motion/remainder.h"
#include "gyromode/motion/response.h"
#include "gyromode/motion/zero_part.h"

#include <optional>
#include <vector>

namespace gyromode {

/// The motion of one connected component in its three parts.
class ComponentMotion {
 public:
  ComponentMotion(const System& system, const SolvedComponent& c);

  /// Takes the state apart, then what lasting forces push: `forces[k]` with accelerations `pushes[k]` = M⁻¹f and course cos(frequencies[k] · t), all in the order of the component.
  void start(const State& w, const std::vector<Vector>& forces, const std::vector<Vector>& pushes, const std::vector<double>& frequencies);

  const std::vector<Index>& order() const { return order_; }
  State at(double t) const;
  void add_shares(Index n, std::vector<ModalShare>& to) const;
  double zero_energy() const;
  double remainder_energy() const;
  Index remainder_size() const { return rest_ ? rest_->size() : 0; }
  /// Norms in √(q̇ᵀMq̇ + ω²qᵀMq), ω a frequency of the size of the largest: of the initial state, and of what the parts miss of it.
  double size() const { return size_; }
  double departure() const { return departure_; }

 private:
  struct Drive {  // a lasting force on each part
    ComplexVector on_modes;
    Vector on_zero, on_remainder;
    double nu = 0;
  };

  double norm(const State& w) const;
  State project(const State& w);
  void follow_rest(const State& left, const std::vector<Vector>& pushes);

  std::vector<Index> order_;
  ComponentMatrices matrices_;
  ModalPart modal_;
  ZeroPart zero_;
  std::optional<Remainder> rest_;
  ComplexVector a_;  // of the modes at t = 0
  Vector zero_start_, rest_start_;
  std::vector<Drive> drives_;
  double unit_ = 1, size_ = 0, departure_ = 0;
};

/// ½q̇ᵀMq̇ + ½qᵀKq.
double energy_of(const State& w, const Matrix& mass, const Matrix& stiffness);

}  // namespace gyromode
