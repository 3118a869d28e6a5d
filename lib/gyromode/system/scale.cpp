#include "gyromode/system/scale.h"

#include <cmath>

namespace gyromode {

namespace {

template <class AnyMatrix>
Vector equilibrate(const AnyMatrix& a) {
  if (a.rows() == 0) return Vector();
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

std::pair<Vector, Vector> own_weights_of_coupling(const Matrix& b) {
  constexpr int sweeps = 8;
  Vector rows = Vector::Ones(b.rows()), columns = Vector::Ones(b.cols());
  const auto step = [](double largest) { return largest > 0 ? 1 / std::sqrt(largest) : 1; };
  Vector row_largest(b.rows());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    row_largest.setZero();
    Vector column_largest(b.cols());
    for (Index k = 0; k < b.cols(); ++k) {
      const auto size = (rows.array() * b.col(k).array().abs() * columns(k)).eval();
      column_largest(k) = size.size() > 0 ? size.maxCoeff() : 0;
      row_largest = row_largest.array().max(size);
    }
    rows = rows.array() * row_largest.unaryExpr(step).array();
    columns = columns.array() * column_largest.unaryExpr(step).array();
    const auto settled = [](const Vector& v) { return ((v.array() == 0) || (v.array() > 0.5 && v.array() < 2)).all(); };
    if (settled(row_largest) && settled(column_largest)) break;
  }
  const auto weights = [](const Vector& scale, const Vector& largest) {
    return Vector((largest.array() > 0).select(scale.array().square().inverse(), 0));
  };
  Vector column_largest = b.rows() > 0 ? Vector(b.cwiseAbs().colwise().maxCoeff().transpose()) : Vector(Vector::Zero(b.cols()));
  return {weights(rows, row_largest), weights(columns, column_largest)};
}

Vector own_weights(const Matrix& a) { return own_weights_of_coupling(a).first; }

Matrix entry_scale(const Matrix& a) {
  const auto [rows, columns] = own_weights_of_coupling(a);
  return a.cwiseAbs().cwiseMax(rows.cwiseSqrt() * columns.cwiseSqrt().transpose());
}

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

namespace {

template <class AnyMatrix>
AnyMatrix in_place(AnyMatrix& a, const Vector& d) {
  for (Index k = 0; k < a.cols(); ++k) a.col(k) = (d(k) * a.col(k).array() * d.array()).matrix();
  return std::move(a);
}

}  // namespace

Matrix scaled(Matrix&& a, const Vector& d) { return in_place(a, d); }
ComplexMatrix scaled(ComplexMatrix&& a, const Vector& d) { return in_place(a, d); }

double norm1(const Matrix& a) { return a.size() == 0 ? 0 : a.cwiseAbs().colwise().sum().maxCoeff(); }
double norm1(const ComplexMatrix& a) {
  if (a.size() == 0) return 0;
  const double part = std::max(a.real().cwiseAbs().maxCoeff(), a.imag().cwiseAbs().maxCoeff());
  const bool squares = part > 1e-140 && part < 1e140;  // |z|² is quick, hypot is not
  return squares ? a.cwiseAbs2().cwiseSqrt().colwise().sum().maxCoeff() : a.cwiseAbs().colwise().sum().maxCoeff();
}

}  // namespace gyromode
