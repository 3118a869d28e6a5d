#pragma once

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/groups.h"
#include "gyromode/sparse/null_space.h"
#include "gyromode/sparse/sparse_system.h"

#include <memory>
#include <vector>

namespace gyromode::sparse {

/// K as factors: of K₁ and K₂, the blocks of the groups of a partition, or of K whole where there is none. Of a block
/// that is singular to rounding null(K) is known, and the inverse is one on what is M-orthogonal to it.
class StiffnessFactors {
 public:
  /// @throws TooLarge; NotApplicable where a null space cannot be told from soft motions
  StiffnessFactors(const SparseSystem& system, const Groups& groups);
  ~StiffnessFactors();

  Index blocks() const { return static_cast<Index>(blocks_.size()); }
  Index negative(Index block) const { return blocks_[static_cast<std::size_t>(block)].negative; }
  Index negative() const;
  /// Whether it is that of the coordinates in quadrature.
  bool across(Index block) const { return blocks_[static_cast<std::size_t>(block)].across; }
  Index nullity(Index block) const { return blocks_[static_cast<std::size_t>(block)].null_space.basis.cols(); }
  Index nullity() const;
  /// N of a block, n × r: NᵀMN = 1, with rows of that block alone.
  Matrix null_space(Index block) const;
  /// The least ω² at rest of a block that is not zero, about; only of a singular block, else infinite.
  double next(Index block) const { return blocks_[static_cast<std::size_t>(block)].null_space.next; }
  /// K⁻¹B in the rows of one block; the other rows of B are not looked at, and come back as 0. Of a singular one X with
  /// NᵀMX = 0, KX = B − MN(NᵀB). n × m
  Matrix solve(Index block, const Matrix& b) const;
  /// The same of the rows of that block alone, which is not singular.
  Matrix solve_block(Index block, Matrix b) const { return factor_of(blocks_[static_cast<std::size_t>(block)]).solve(std::move(b)); }
  /// Forgets the factors, which makes room; a solve that needs one factors again.
  void release() const;

 private:
  struct Block {
    std::vector<Index> rows;
    bool across = false;
    SparseMatrix mass;
    SymmetricFactor::Kind kind = SymmetricFactor::Kind::definite;
    mutable std::unique_ptr<SymmetricFactor> factor;  // of K, or of K − νM where K is singular
    Index negative = 0;
    NullSpace null_space;
  };
  SymmetricFactor& factor_of(const Block& of) const;
  Matrix solve_singular(const Block& of, const Matrix& b) const;
  const SparseSystem& system_;
  std::vector<Block> blocks_;
};

}  // namespace gyromode::sparse
