#include "gyromode/roots/singularity.h"

#include "gyromode/lapack/small.h"

#include <algorithm>

namespace gyromode {

ComplexMatrix equilibrated_block(const BlockedImpedance& h, const Block& block, const Complex& omega) {
  const ComplexMatrix whole = h.impedance.at(omega);
  ComplexMatrix a = whole(block.coordinates, block.coordinates);
  for (Index i = 0; i < a.rows(); ++i) {
    a.row(i) /= std::max(1.0, a.row(i).cwiseAbs().maxCoeff());
  }
  for (Index i = 0; i < a.cols(); ++i) {
    a.col(i) /= std::max(1.0, a.col(i).cwiseAbs().maxCoeff());
  }
  return a;
}

double relative_singularity(const ComplexMatrix& a) {
  const Vector s = small::singular_values(a);
  return s(s.size() - 1) / s(0);
}

}  // namespace gyromode
