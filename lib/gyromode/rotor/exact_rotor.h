#pragma once

#include "gyromode/roots/lifted_impedance.h"
#include "gyromode/rotor/exact_shaft.h"
#include "gyromode/rotor/rotor.h"

#include <vector>

namespace gyromode {

/// The impedance of a rotor whose shafts are exact Rayleigh ones, on the coordinates of its stations: transcendental,
/// without the error of finite elements. Up to reach() no piece between two stations has a motion of its own with its
/// ends clamped, so that n₋ counts the modes (Wittrick and Williams 1971); more elements reach farther.
///
/// Frequencies in rad/s; coordinates scaled so that the static stiffness of each is 1.
class ExactRotor : public LiftedImpedance {
 public:
  /// @throws NotApplicable unless every shaft is uniform and of the theory 'rayleigh'
  explicit ExactRotor(const Rotor& rotor);

  /// ω, rad/s, up to which the count holds.
  double reach() const { return reach_; }

  Index size() const override { return mass_.rows(); }
  Couplings couplings() const override;
  Lifted at(double omega) const override;
  ComplexMatrix at(Complex omega) const override;
  double rounding(double omega) const override;

 private:
  struct Piece {
    std::array<Index, 4> x, y;  // (x, θy) and (y, θx) at both ends; −1: held
    ExactPiece exact;
  };
  template <class T>
  void add(const Piece& piece, const T& omega, ComplexMatrix& to) const;
  template <class T>
  ComplexMatrix impedance(const T& omega) const;

  Matrix mass_, gyroscopic_, stiffness_;  // of what the shafts carry
  std::vector<Piece> pieces_;
  Vector scale_;
  double reach_ = 0;
};

}  // namespace gyromode
