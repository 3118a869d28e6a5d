#pragma once

#include "gyromode/lapack/multiply.h"
#include "gyromode/sparse/free_motions.h"

#include <vector>

namespace gyromode::sparse {

/// A growing real basis V (n × p), VᵀMV = 1, with MV kept and K and G projected on it. With a partition every column
/// has entries of one group alone, so that the projected system has the partition too.
class Subspace {
 public:
  /// Holds null(K) from the beginning, with what is zero of VᵀKV and VᵀGV exactly zero; never translations that are
  /// left out.
  Subspace(const SparseSystem& system, const Groups& groups, const FreeMotions& free);

  /// Adds what is new in the columns of x (n × m), group by group. @returns the coefficients of x in V after that, p ×
  /// m
  Matrix add(const Matrix& x);
  /// Coefficients of V that stand in as x = V c and Mx.
  Matrix combined(const Matrix& c) const { return lapack::multiply(v_.leftCols(size()), c); }
  Matrix mass_times(const Matrix& c) const { return lapack::multiply(mv_.leftCols(size()), c); }

  Index size() const { return size_; }
  /// VᵀKV and VᵀGV, p × p; exactly (skew-)symmetric.
  Matrix stiffness() const { return k_.topLeftCorner(size_, size_); }
  Matrix gyroscopic() const { return g_.topLeftCorner(size_, size_); }
  /// Of every column, whether it is in quadrature.
  const std::vector<bool>& across() const { return column_across_; }
  /// Keeps what the combinations of columns given (p × any number) span, and null(K).
  void keep(const Matrix& c);

 private:
  void append(const Matrix& fresh, bool across);
  void reserve(Index columns);

  const SparseSystem& system_;
  const FreeMotions& free_;
  std::vector<Index> rows_[2];  // in phase, in quadrature
  bool partition_;
  Index size_ = 0, null_ = 0;
  Matrix v_, mv_, k_, g_;
  std::vector<bool> column_across_;
};

}  // namespace gyromode::sparse
