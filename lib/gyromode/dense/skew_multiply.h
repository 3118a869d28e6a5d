#pragma once

#include "gyromode/lapack/types.h"

#include <memory>

namespace gyromode::dense {

/// y = Z v for skew Z given by its strictly lower triangle; rows and columns from `first` on. Every entry is read once.
void skew_multiply(const Matrix& z, Index first, const double* v, double* y);

/// The same many times over, by as many threads as the BLAS uses: the product is limited by memory bandwidth, and one core does not exhaust it. The columns are
/// cut into parts of equal area, each with a result of its own, summed at the end.
class SkewMultiply {
 public:
  explicit SkewMultiply(Index largest);
  ~SkewMultiply();
  SkewMultiply(const SkewMultiply&) = delete;
  SkewMultiply& operator=(const SkewMultiply&) = delete;

  void operator()(const Matrix& z, Index first, const double* v, double* y);

 private:
  struct Team;
  std::unique_ptr<Team> team_;  ///< none where one thread does it
};

}  // namespace gyromode::dense
