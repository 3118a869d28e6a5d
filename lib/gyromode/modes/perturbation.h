#pragma once

#include "gyromode/modes/root_vectors.h"
#include "gyromode/system/symmetry.h"

namespace gyromode {

/// What a dropped part D of a matrix does to roots: N(λ) becomes N(λ) + Δ(λ), Δ = λᵖD, p = 2, 1, 0 for M, G, K (1, 0
/// for I, G of first order), and the roots become the eigenvalues of
///     diag(λ_k) + B,   B_kl = −y_kᴴΔ x_l / d_k   (theory (T15), (T16)),
/// d_k the slopes. Only the rows and columns of B that are asked for are formed.
class Perturbation {
 public:
  /// `chosen`: the positions of the roots whose movement will be asked for. Neither argument is copied.
  Perturbation(const RootVectors& roots, const Repair& repair, bool first_order, const std::vector<Index>& chosen);

  /// How far root i of those chosen moves: with those that B brings to it as one block, by the others in second order,
  /// `by_others` added to that.
  double moves(Index i, Complex by_others) const;
  /// λᵖ.
  Complex power(Complex lambda) const;

 private:
  Complex b(Index k, Index l, Complex power_at) const;
  double own(Index k) const;
  bool is_formed(const RootPlace& root) const;
  std::vector<Index> near(Index i) const;
  std::vector<Index> near(Index i, double apart) const;
  void form_products(const std::vector<Index>& chosen);
  Complex product(const VectorPlace& left, const VectorPlace& right) const;
  Complex by_massless(Index i) const;
  Complex formed(const VectorPlace& left, const VectorPlace& right) const;

  const RootVectors& roots_;
  const Repair& repair_;
  int order_;                 // p
  double parity_;             // Dᵀ = parity·D
  double norm_;               // ‖D‖
  Vector length_;             // |x| of every column
  std::vector<Index> place_;  // of every column among those of products_, −1: not formed
  Index places_ = 0;          // columns formed
  Matrix of_massless_;        // rows of D of massless coordinates
  Matrix products_;           // partsᵀ D (parts of the columns formed)
};

}  // namespace gyromode
