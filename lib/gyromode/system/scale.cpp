#include "gyromode/system/scale.h"

#include <cmath>

namespace gyromode {

namespace {

template <class AnyMatrix>
Vector equilibrate(const AnyMatrix& a) {
  constexpr int sweeps = 5;  // each sweep takes the square root of the imbalance
  Matrix size = a.cwiseAbs();
  Vector d = Vector::Ones(a.rows());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    const Vector largest = size.colwise().maxCoeff().transpose();
    Vector step(a.rows());
    for (Index i = 0; i < a.rows(); ++i) step(i) = power_of_two_near(largest(i) > 0 ? 1 / std::sqrt(largest(i)) : 1);
    if ((step.array() == 1).all()) break;
    size = step.asDiagonal() * size * step.asDiagonal();
    d.array() *= step.array();
  }
  return d;
}

}  // namespace

double power_of_two_near(double x) { return x == 0 ? 1 : std::exp2(std::round(std::log2(x))); }

Vector unit_diagonal_scale(const Matrix& a) {
  Vector d(a.rows());
  for (Index i = 0; i < a.rows(); ++i) d(i) = a(i, i) == 0 ? 1 : power_of_two_near(1 / std::sqrt(std::abs(a(i, i))));
  return d;
}

Vector equilibrating_scale(const Matrix& a) { return equilibrate(a); }
Vector equilibrating_scale(const ComplexMatrix& a) { return equilibrate(a); }

Matrix scaled(const Matrix& a, const Vector& d) { return d.asDiagonal() * a * d.asDiagonal(); }
ComplexMatrix scaled(const ComplexMatrix& a, const Vector& d) { return d.asDiagonal() * a * d.asDiagonal(); }

double norm1(const Matrix& a) { return a.size() == 0 ? 0 : a.cwiseAbs().colwise().sum().maxCoeff(); }
double norm1(const ComplexMatrix& a) { return a.size() == 0 ? 0 : a.cwiseAbs().colwise().sum().maxCoeff(); }

}  // namespace gyromode
