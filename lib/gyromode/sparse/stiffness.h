#pragma once

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/sparse_system.h"

#include <memory>
#include <vector>

namespace gyromode::sparse {

/// K as factors: of K₁ and K₂, the blocks of the groups of a partition, or of K whole where there is none.
class StiffnessFactors {
 public:
  /// @throws TooLarge
  StiffnessFactors(const SparseSystem& system, const Groups& groups);
  ~StiffnessFactors();

  Index blocks() const { return static_cast<Index>(blocks_.size()); }
  Index negative(Index block) const { return blocks_[static_cast<std::size_t>(block)].negative; }
  Index negative() const;
  /// How far a block is from singular: the least |xᵀKx| over |x|ᵀ|K||x| that inverse iteration finds.
  double margin(Index block) const { return blocks_[static_cast<std::size_t>(block)].margin; }
  double margin() const;
  bool definite(Index block) const;
  /// K⁻¹B in the rows of one block; the other rows of B are not looked at, and come back as 0. n × m
  Matrix solve(Index block, const Matrix& b) const;
  /// The same of the rows of that block alone.
  Matrix solve_block(Index block, Matrix b) const { return blocks_[static_cast<std::size_t>(block)].factor->solve(std::move(b)); }

 private:
  struct Block {
    std::vector<Index> rows;
    std::unique_ptr<SymmetricFactor> factor;
    Index negative = 0;
    double margin = 0;
  };
  const SparseSystem& system_;
  std::vector<Block> blocks_;
};

}  // namespace gyromode::sparse
