#include "gyromode/appendage/spring_mass.h"

#include "gyromode/appendage/row_kinds.h"

#include <cmath>

namespace gyromode {

namespace {

// −N₃(ζ + θ × p) + Ω² θ × Pp on (ξ, θ1, θ2, φ3); the two terms of φ3 together are divided by ω.
template <class T>
Eigen::Matrix<Complex, 3, body_coordinates> rows_of(const SpinOperators<T>& f, const Eigen::Vector3d& at) {
  const double x = at(0), y = at(1), z = at(2);
  const double square = f.spin * f.spin;
  Eigen::Matrix<Complex, 3, body_coordinates> r = Eigen::Matrix<Complex, 3, body_coordinates>::Zero();
  r(0, 0) = r(1, 1) = r(2, 2) = -f.omega;
  r(0, 1) = -f.j * f.spin;
  r(1, 0) = f.j * f.spin;
  r(0, 3) = f.j * f.t * z;  // θ × p = (θ2 z, −θ1 z, θ1 y − θ2 x)
  r(0, 4) = -f.p * z;
  r(1, 3) = f.p * z;
  r(1, 4) = f.j * f.t * z;
  r(2, 3) = (square - f.omega * f.omega) * y;  // θ × Pp = (0, 0, θ1 y − θ2 x)
  r(2, 4) = (f.omega * f.omega - square) * x;
  r(0, 5) = f.omega * y - 2.0 * f.j * f.spin * x;  // θ × p = θ × Pp = θ3 (−y, x, 0)
  r(1, 5) = -f.omega * x - 2.0 * f.j * f.spin * y;
  return r;
}

// The kinds of rows_of(): a coordinate of the position that is zero takes its entries with it.
std::array<RowKinds, 3> kinds_of_rows(const Eigen::Vector3d& at) {
  using enum EntryKind;
  const bool x = at(0) != 0, y = at(1) != 0, z = at(2) != 0;
  const EntryKind r = z ? real : none, i = z ? imaginary : none;
  const EntryKind turned1 = x ? (y ? complex : imaginary) : (y ? real : none), turned2 = x ? (y ? complex : real) : (y ? imaginary : none);
  return {{{real, imaginary, none, i, r, turned1},
           {imaginary, real, none, r, i, turned2},
           {none, none, real, y ? real : none, x ? real : none, none}}};
}

}  // namespace

SpringMassAppendage::SpringMassAppendage(const SpringMass& mass, double spin) : mass_(mass), spin_(spin) {
  for (Index i = 0; i < 3; ++i) {
    if (std::isfinite(mass_.stiffness(i))) sprung_.push_back(i);
  }
}

double SpringMassAppendage::scale(double omega, Index a) const {
  return 1 / std::sqrt(mass_.stiffness(sprung_[static_cast<std::size_t>(a)]) + mass_.mass * (omega * omega + spin_ * spin_));
}

void SpringMassAppendage::couple(Couplings& to, Index first) const {
  const auto rows = kinds_of_rows(mass_.position);
  for (Index a = 0; a < coordinates(); ++a) add_row(to, first + a, rows[static_cast<std::size_t>(sprung_[static_cast<std::size_t>(a)])]);
  if (coordinates() > 1 && sprung_[0] == 0 && sprung_[1] == 1) to.add(first, first + 1, CouplingKind::cross);  // N₃
}

template <class T>
void SpringMassAppendage::add_to(const T& omega, Lifted& to, Index first) const {
  const SpinOperators<T> plus(omega, spin_, Complex(0, 1)), minus(omega, spin_, Complex(0, -1));
  const auto right = rows_of(plus, mass_.position), left = rows_of(minus, mass_.position);
  const Eigen::Matrix3cd n = inertia_operator(plus);
  for (Index a = 0; a < coordinates(); ++a) {
    const Index i = sprung_[static_cast<std::size_t>(a)];
    const double s = scale(omega, a);
    for (Index b = 0; b < coordinates(); ++b)
      to.matrix(first + a, first + b) = s * scale(omega, b) * -mass_.mass * n(i, sprung_[static_cast<std::size_t>(b)]);
    to.matrix(first + a, first + a) += s * s * mass_.stiffness(i);
    to.matrix.row(first + a).head<body_coordinates>() = s * mass_.mass * right.row(i);
    to.matrix.col(first + a).head<body_coordinates>() = s * mass_.mass * left.row(i).transpose();
  }
}

Eigen::Vector2cd SpringMassAppendage::first_moment(double omega, const ComplexVector&, const ComplexVector& own) const {
  Eigen::Vector2cd moment = Eigen::Vector2cd::Zero();
  for (Index a = 0; a < coordinates(); ++a) {
    if (sprung_[static_cast<std::size_t>(a)] < 2) moment(sprung_[static_cast<std::size_t>(a)]) = mass_.mass * scale(omega, a) * own(a);
  }
  return moment;
}

std::vector<ComplexMatrix> SpringMassAppendage::displaced(double omega, const ComplexVector&, const ComplexVector& own) const {
  ComplexMatrix u = ComplexMatrix::Zero(3, 1);
  for (Index a = 0; a < coordinates(); ++a) u(sprung_[static_cast<std::size_t>(a)], 0) = scale(omega, a) * own(a);
  return {u};
}

}  // namespace gyromode
