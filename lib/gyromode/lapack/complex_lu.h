#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::lapack {

/// P L U of a complex n × n matrix (zgetrf).
class ComplexLu {
 public:
  explicit ComplexLu(ComplexMatrix a);

  /// A⁻¹b and A⁻ᴴb, b n × m. Not finite where A is singular to the last bit.
  ComplexMatrix solve(ComplexMatrix b) const;
  ComplexMatrix solve_adjoint(ComplexMatrix b) const;

 private:
  ComplexMatrix back_substitute(ComplexMatrix b, char which) const;

  ComplexMatrix factors_;
  std::vector<int> pivots_;
};

}  // namespace gyromode::lapack
