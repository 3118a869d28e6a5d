#pragma once

#include "gyromode/sparse/inverse.h"
#include "gyromode/sparse/free_motions.h"

#include <memory>

namespace gyromode::sparse {

/// An operator on states without those of free motions. Its inner product E = diag(K, M) is semidefinite where K is:
/// displacements are without their part of null(K), which E does not see, and what drifts, A(R, N₀) = (N₀, 0), is
/// taken away E-orthogonally, so that every root that is left is not zero; translations with their velocities.
class Deflated : public Inverse {
 public:
  Deflated(std::unique_ptr<Inverse> of, const Groups& groups, const FreeMotions& free);

  Index length() const override { return of_->length(); }
  Index dimension() const override { return of_->dimension() - out_.cols(); }
  bool skew() const override { return of_->skew(); }
  States start(const Matrix& shapes) const override { return without_free(of_->start(shapes)); }
  States apply(const States& u) const override { return without_free(of_->apply(u)); }
  Matrix inner(const Matrix& x) const override { return of_->inner(x); }
  void settle(States& u) const override { of_->settle(u); }
  bool rough_products() const override { return of_->rough_products(); }
  double square(double theta) const override { return of_->square(theta); }
  Index leading_group() const override { return of_->leading_group(); }
  bool motions() const override { return of_->motions(); }
  Matrix shapes(const Matrix& states) const override { return of_->shapes(states); }
  Matrix states(const Matrix& in_order) const override { return of_->states(in_order); }

 private:
  States without_free(States w) const;

  std::unique_ptr<Inverse> of_;
  Matrix out_, weight_, e_out_;  // w loses out · (weightᵀ w), E w e_out · that
};

}  // namespace gyromode::sparse
