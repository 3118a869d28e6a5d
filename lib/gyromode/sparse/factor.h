#pragma once

#include "gyromode/sparse/matrix.h"

#include <memory>
#include <vector>

namespace gyromode::sparse {

/// A = Pᵀ L D Lᵀ P of symmetric sparse matrices of one pattern, with pivoting (MUMPS): the pattern is analysed once. L
/// is kept in memory where there is room for it as factor_memory() says, else in files.
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
  /// rounding. @throws TooLarge, with the memory that it would take, where that is more than there is or may be used
  Index factor(const SparseMatrix& lower);
  /// A⁻¹B, n × m.
  Matrix solve(Matrix b);
  /// Megabytes that it is estimated to take.
  double megabytes() const;
  /// The same with L in files, of some megabytes.
  double megabytes_beside_files() const;
  double megabytes_in_files() const;
  /// Whether L is there.
  bool in_files() const { return in_files_; }
  /// Entries of L, as analysed.
  double entries() const;

 private:
  void choose_place();

  struct Instance;
  std::unique_ptr<Instance> of_;
  Keep keep_;
  Index size_ = 0, non_zeros_ = 0;
  bool singular_ = false, placed_ = false, in_files_ = false;
};

}  // namespace gyromode::sparse
