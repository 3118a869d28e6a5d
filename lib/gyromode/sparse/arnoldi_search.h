#pragma once

#include "gyromode/sparse/krylov.h"
#include "gyromode/sparse/search.h"

#include <memory>

namespace gyromode::sparse {

/// By Krylov spaces without an inner product that fits, of K of any sign; what they hold is projected on, and restarted
/// from the motions nearest to the shift.
class ArnoldiSearch : public Search {
 public:
  ArnoldiSearch(const SparseSystem& system, const Groups& groups, const Norms& norms, const FreeMotions& free, Resolvent resolvent,
                Index wanted);

  bool step() override;
  void refresh(Index width) override;
  std::vector<Expected> look() const override;
  Found found(const Window& range) const override;
  Index applied() const override { return applied_; }

 private:
  void restart();

  const SparseSystem& system_;
  const Groups& groups_;
  const Norms& norms_;
  Resolvent resolvent_;
  Index wanted_, most_, applied_ = 0;
  unsigned draws_ = 0;
  double tolerance_;
  Subspace v_;
  std::unique_ptr<Krylov> krylov_;
};

}  // namespace gyromode::sparse
