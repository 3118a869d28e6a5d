#pragma once

#include "gyromode/spectrum/result.h"
#include "gyromode/structure/quadrature.h"
#include "gyromode/system/system.h"

#include <vector>

namespace gyromode {

/// One component of a system seen from kept coordinates b, the others i. With H(ω) = [A, B; Bᴴ, D] a motion in which b
/// rests is (0, v) with
///     C(ω) v = 0,   C = [B; D],   v ≠ 0,
/// so that at ω there are dim null D − rank(B on null D) local modes, whatever other modes are there (theory §4).
///
/// Rank is decided on C̃ = RCS, S the powers of two that equilibrate |K_ii| + ω|G_ii| + ω²|M_ii|, R the same for the
/// rows of D; each row of B is brought to a largest entry of 1 by itself, so that a coupling counts as it is given,
/// however small beside A and D. With ‖ṽ‖₂ = 1, v = Sṽ is local where
///     ‖C̃ṽ‖₂ ≤ 30 max(n, 2) ε   and   ‖C̃ṽ‖₂ + nε ≤ 10⁻⁸ ω |vᴴ(2ωM − jG)v|:
/// a backward error of rounding size explains what is left, and moves the root by 10⁻⁸ω at most. Where it would move it
/// by more, detuned parts could pass for equal ones: not decided.
class ComponentSeenFrom {
 public:
  /// `kept` are coordinates of the system; those of the component count.
  ComponentSeenFrom(const System& system, const Component& component, const std::vector<Index>& kept);

  Index kept() const { return kept_; }
  Index internal() const { return static_cast<Index>(order_.size()) - kept_; }

  /// `near` are modes of this component with shapes, neighbours in frequency. Those that are local become so, their
  /// shapes exactly zero in b; the other shapes are made conjugate to these, Xᴴ((ω₁ + ω₂)M − jG)Y = 0. Where local and
  /// other modes coincide, this is the basis that tells them apart.
  void mark_local(const std::vector<Mode*>& near) const;

 private:
  struct Scales;
  struct Subspace;
  struct Local;
  ComplexMatrix internal_images(const ComplexMatrix& of, const ComplexMatrix& v) const;
  Subspace spanned(const Scales& s, const ComplexMatrix& basis) const;
  ComplexMatrix scaled_columns(const Scales& s, double omega) const;
  std::vector<Local> take_null_vectors(const Scales& s, Subspace& v, double& omega) const;
  std::vector<Local> locals(const Scales& s, const ComplexMatrix& shapes, const std::vector<Mode*>& near) const;
  ComplexVector conjugate_part(const ComplexVector& x, double omega, const std::vector<Local>& to) const;
  Scales scales(double omega) const;
  void assign(const Scales& s, const ComplexMatrix& shapes, const std::vector<Mode*>& modes, const std::vector<Local>& mine,
              const std::vector<Local>& all) const;
  ComplexVector in_system(const ComplexVector& x, Index n) const;

  std::vector<Index> order_;  // positions in the system, b first
  Index kept_ = 0;
  ComplexVector phase_;                          // T of a quadrature partition, else 1: with it all that follows is real there
  ComplexMatrix stiffness_, gyroscopic_, mass_;  // T⁻¹KT, T⁻¹(jG)T, T⁻¹MT in that order
};

}  // namespace gyromode
