#pragma once

#include "gyromode/lapack/team.h"
#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::dense {

/// y = Z v for skew Z given by its strictly lower triangle; rows and columns from `first` on. Every entry is read once.
void skew_multiply(const Matrix& z, Index first, const double* v, double* y);

/// The same many times over by a team: the product is limited by memory bandwidth, and one core does not exhaust it.
/// The columns are cut into parts of equal area, each with a result of its own, summed at the end.
class SkewMultiply {
 public:
  SkewMultiply(lapack::Team& team, Index largest);

  void operator()(const Matrix& z, Index first, const double* v, double* y);

 private:
  lapack::Team& team_;
  std::vector<Vector> results_;
};

/// First column of `part` when the lower triangle of order n is cut into `parts` of equal area.
Index equal_area(Index n, int part, int parts);

}  // namespace gyromode::dense
