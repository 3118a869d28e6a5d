#pragma once

#include "gyromode/sparse/free_motions.h"
#include "gyromode/sparse/inverse.h"

#include <memory>

namespace gyromode::sparse {

/// States D that are taken away from others, in the order that an operator has them: w loses D Lᵀw, LᵀD = 1.
struct TakenAway {
  Matrix out, weight, e_out;  ///< D, L and ED
};

/// Those of free motions. E = diag(K, M) is semidefinite where K is: displacements are without their part of null(K),
/// which E does not see, and what drifts, A(R, N₀) = (N₀, 0), is taken away E-orthogonally, so that every root that is
/// left is not zero; translations with their velocities.
TakenAway free_states(const FreeMotions& free, const Groups& groups, const Inverse& of);

/// An operator on states without some.
class Deflated : public Inverse {
 public:
  Deflated(std::unique_ptr<Inverse> of, TakenAway states) : of_(std::move(of)), states_(std::move(states)) {}

  Index length() const override { return of_->length(); }
  Index dimension() const override { return of_->dimension() - states_.out.cols(); }
  bool skew() const override { return of_->skew(); }
  States start(const Matrix& shapes) const override { return without(of_->start(shapes)); }
  States apply(const States& u) const override { return without(of_->apply(u)); }
  Matrix inner(const Matrix& x) const override { return of_->inner(x); }
  void settle(States& u) const override { of_->settle(u); }
  bool rough_products() const override { return of_->rough_products(); }
  double square(double theta) const override { return of_->square(theta); }
  Index leading_group() const override { return of_->leading_group(); }
  bool motions() const override { return of_->motions(); }
  Matrix shapes(const Matrix& states) const override { return of_->shapes(states); }
  Matrix states(const Matrix& in_order) const override { return of_->states(in_order); }

 private:
  States without(States w) const;

  std::unique_ptr<Inverse> of_;
  TakenAway states_;
};

}  // namespace gyromode::sparse
