#pragma once

#include "rows.h"

namespace gyromode::bench {

/// Residuals of one method on one system, in units of n ε: ‖(λ²M + λG + K)x‖₂ / ((‖K‖ + |λ|‖G‖ + |λ|²‖M‖)‖x‖₂), 1-norms
/// of matrices, over one root of every pair and quadruple that has a vector.
struct Score {
  std::string system;
  std::string method;
  Index order = 0;  ///< n of the unit n ε: that of the matrices the method's residual is measured on
  Index modes = 0;
  double median = 0;
  double worst = 0;
  /// Largest |Re λ| / max |λ| where no motion grows: what the method adds. None where there is flutter.
  std::optional<double> real_part;
};

/// The systems of rows a, b and c at n = 200, 200 and 100, times n_scale.
std::vector<Score> accuracy_league(const RowOptions& options);

}  // namespace gyromode::bench
