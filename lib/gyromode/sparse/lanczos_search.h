#pragma once

#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/lanczos.h"
#include "gyromode/sparse/search.h"
#include "gyromode/sparse/free_motions.h"

#include <memory>

namespace gyromode::sparse {

/// By Lanczos with an operator that is (skew-)self-adjoint in a definite inner product; what it finds is projected on.
class LanczosSearch : public Search {
 public:
  /// `beside`: roots that the operator does not have, for the gaps between all; `wanted`: about how many roots will be
  /// asked for.
  LanczosSearch(const SparseSystem& system, const Groups& groups, const Norms& norms, const FreeMotions& free,
                std::unique_ptr<Inverse> inverse, std::vector<double> beside, Index wanted);

  bool step() override { return lanczos_.step(); }
  void refresh(Index width) override { lanczos_.refresh(width); }
  std::vector<Expected> look() const override;
  Found found(const Window& range) const override;
  Index applied() const override { return lanczos_.applied(); }

 private:
  /// Of the residual of an eigenvalue θ, relative, so that the motion has the residual asked for.
  double tolerance(double theta) const;
  Found measured_motions(const Lanczos::Ritz& r, const std::vector<Index>& chosen, std::vector<double> omega) const;

  const SparseSystem& system_;
  const Groups& groups_;
  const Norms& norms_;
  const FreeMotions& free_;
  std::unique_ptr<Inverse> inverse_;
  std::vector<double> beside_;
  Lanczos lanczos_;
  double stiffest_;  // about the largest ω² at rest
};

}  // namespace gyromode::sparse
