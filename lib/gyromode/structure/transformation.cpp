#include "gyromode/structure/transformation.h"

#include <Eigen/Eigenvalues>

namespace gyromode {

namespace {

Transformation constant(double omega, const ComplexMatrix& h, const Structure& structure) {
  const Index n = h.rows();
  ComplexVector t = ComplexVector::Ones(n);
  for (const Index i : structure.in_quadrature()) t(i) = Complex(0, -1);
  const ComplexMatrix star = t.conjugate().asDiagonal() * h * t.asDiagonal();
  return {omega, h, t.asDiagonal(), star.real()};
}

Transformation by_householder(double omega, const ComplexMatrix& h) {
  const Eigen::Tridiagonalization<ComplexMatrix> t(h);
  const Index n = h.rows();
  Matrix star = Matrix::Zero(n, n);
  star.diagonal() = t.diagonal();
  if (n > 1) {
    star.diagonal(1) = t.subDiagonal();
    star.diagonal(-1) = t.subDiagonal();
  }
  return {omega, h, t.matrixQ(), star};
}

}  // namespace

Transformation transformation_of(const ComplexMatrix& h, const Structure& structure, double omega) {
  return structure.system_class() == SystemClass::quadrature ? constant(omega, h, structure) : by_householder(omega, h);
}

Transformation transformation_at(const System& system, const Structure& structure, double omega) {
  return transformation_of(system.impedance(omega), structure, omega);
}

Transformation transformation_at(const FirstOrderSystem& system, const Structure& structure, double omega) {
  return transformation_of(system.impedance(omega), structure, omega);
}

}  // namespace gyromode
