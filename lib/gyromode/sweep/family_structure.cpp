#include "gyromode/sweep/family_structure.h"

namespace gyromode {

// Signs do not matter: |G₀| + |G₁| above the diagonal and its negative below, and a positive definite mass.
Structure structure_of(const SpinFamily& f) {
  const Index n = f.mass.rows();
  Matrix k = f.stiffness.cwiseAbs(), g = Matrix::Zero(n, n), m = f.mass.cwiseAbs();
  if (f.stiffness_per_spin2.size() > 0) k += f.stiffness_per_spin2.cwiseAbs();
  for (const Matrix* part : {&f.gyroscopic, &f.gyroscopic_per_spin}) {
    if (part->size() > 0) g += part->cwiseAbs();
  }
  g = (g.triangularView<Eigen::StrictlyUpper>().toDenseMatrix() - g.transpose().triangularView<Eigen::StrictlyLower>().toDenseMatrix())
          .eval();
  m.diagonal().array() += 2 * m.rowwise().sum().maxCoeff();
  return analyse(System(std::move(m), std::move(g), std::move(k), f.labels), HiddenSearch::never);
}

}  // namespace gyromode
