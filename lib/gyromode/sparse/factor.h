#pragma once

#include "gyromode/sparse/matrix.h"

#include <memory>
#include <vector>

namespace gyromode::sparse {

/// A = Pᵀ L D Lᵀ P of symmetric sparse matrices of one pattern, with pivoting (MUMPS): the pattern is analysed once.
class SymmetricFactor {
 public:
  /// What is kept of a factorisation.
  enum class Keep {
    factors,  ///< all of it: systems can be solved
    counts    ///< the signs of the pivots alone, in a fraction of the memory
  };

  /// What may be expected of the matrices.
  enum class Kind {
    indefinite,  ///< pivots are chosen, of order 1 and 2
    definite     ///< no pivoting: faster; where the number of negative pivots is not 0 it is no more than a sign of that
  };

  /// `pattern` by its lower triangle; `order` as node_order() gives it. @throws TooLarge where there is not enough
  /// memory
  SymmetricFactor(const SparseMatrix& pattern, const std::vector<int>& order, Keep keep, Kind kind = Kind::indefinite);
  ~SymmetricFactor();
  SymmetricFactor(const SymmetricFactor&) = delete;
  SymmetricFactor& operator=(const SymmetricFactor&) = delete;

  /// Whether the last one was singular: nothing can be solved with it.
  bool singular() const { return singular_; }
  /// Of a matrix with exactly that pattern. @returns the number of negative pivots, arbitrary where it is singular to
  /// rounding. @throws TooLarge, with the memory that it would take
  Index factor(const SparseMatrix& lower);
  /// A⁻¹B, n × m.
  Matrix solve(Matrix b);
  /// Megabytes that the last factorisation took, or before the first is estimated to take.
  double megabytes() const;
  /// Entries of L, as analysed.
  double entries() const;

 private:
  struct Instance;
  std::unique_ptr<Instance> of_;
  Keep keep_;
  Index size_ = 0, non_zeros_ = 0;
  bool singular_ = false;
};

}  // namespace gyromode::sparse
