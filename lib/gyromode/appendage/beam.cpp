#include "gyromode/appendage/beam.h"

#include "gyromode/appendage/row_kinds.h"

#include <cmath>

namespace gyromode {

namespace {

constexpr Index points_of_a_beam = 33;

Index own_poles_below(double own, double kappa, double phi) { return cantilever_poles_below(kappa, 1, phi) - (own < 0 ? 1 : 0); }
Index own_poles_below(const Complex&, const Complex&, const Complex&) { return 0; }

}  // namespace

MassProperties BeamAppendage::rigid() const {
  const double l = beam_.length, h = beam_.root_height, way = beam_.way();
  const double line = beam_.line_density, tip = beam_.tip_mass;
  MassProperties m;
  m.mass = beam_.mass();
  m.first(2) = line * l * (h + 0.5 * way * l) + tip * (h + way * l);
  m.second(2, 2) = line * l * (h * h + h * way * l + l * l / 3) + tip * (h + way * l) * (h + way * l);
  return m;
}

// The κ of larger modulus from the formula, the other from the product κ₁κ₂ = ρ²(ω² − Ω²)²/(E₁E₂); φ from the angle of
// the symmetric matrix E^−½ ρN E^−½.
template <class T>
BeamAppendage::Cantilevers<T> BeamAppendage::decoupled(const T& omega) const {
  const double density = beam_.line_density;
  const double e1 = beam_.bending_stiffness[0], e2 = beam_.bending_stiffness[1];
  const SpinOperators<T> f(omega, spin_, 0);
  const T first = density / e1 * f.p, second = density / e2 * f.p, cross = density / std::sqrt(e1 * e2) * f.t;
  const T half = 0.5 * (first - second), mean = 0.5 * (first + second);
  T root = std::sqrt(half * half + cross * cross);
  if (std::abs(mean - root) > std::abs(mean + root)) root = -root;
  const T inertia = density * (omega - spin_) * (omega + spin_);
  Cantilevers<T> c;
  const double l = beam_.length;
  const double fourth = l * l * l * l;
  const T larger = mean + root;
  c.kappa[0] = fourth * larger;
  c.kappa[1] = larger == T(0) ? T(0) : fourth * inertia * inertia / (e1 * e2) / larger;
  const bool by_first = std::abs(root + half) >= std::abs(root - half);
  T x = by_first ? T(root + half) : cross;
  T y = by_first ? cross : T(root - half);
  if (x == T(0) && y == T(0)) x = 1;
  const T length = std::sqrt(x * x + y * y);
  x /= length;
  y /= length;
  c.phi[0][0] = x / std::sqrt(e1);
  c.phi[0][1] = y / std::sqrt(e2);
  c.phi[1][0] = -y / std::sqrt(e1);
  c.phi[1][1] = x / std::sqrt(e2);
  return c;
}

// Rows of the loads 1 and s/l of a cantilever of unit length, times l^(5/2): ρφᵀN(ζ + z(θ2, −θ1)), z = h ± s, with Nζ =
// Bξ and η = jY.
template <class T>
BeamAppendage::Rows BeamAppendage::loads(const T& omega, const T (&phi)[2], Complex j) const {
  const SpinOperators<T> f(omega, spin_, j);
  const double l = beam_.length;
  const double weight = beam_.line_density * l * l * std::sqrt(l);
  Rows r = Rows::Zero();
  const Complex x = weight * phi[0];
  const Complex y = weight * j * phi[1];
  r(0, 0) = x * f.omega - y * j * f.spin;
  r(0, 1) = x * j * f.spin + y * f.omega;
  const Complex tilt1 = -x * j * f.t - y * f.p;  // N(θ2, −θ1)
  const Complex tilt2 = x * f.p - y * j * f.t;
  r(0, 3) = beam_.root_height * tilt1;
  r(0, 4) = beam_.root_height * tilt2;
  r(1, 3) = beam_.way() * l * tilt1;
  r(1, 4) = beam_.way() * l * tilt2;
  return r;
}

// Both loads of both cantilevers: ξ1 and θ2 real, ξ2 and θ1 imaginary.
void BeamAppendage::couple(Couplings& to, Index first) const {
  using enum EntryKind;
  constexpr RowKinds load{real, imaginary, none, imaginary, real, none};
  add_product(to, load, load);
  for (Index k = 0; k < 2; ++k) add_row(to, first + k, load);
}

template <class T>
void BeamAppendage::add_to(const T& omega, Lifted& to, Index first) const {
  const Cantilevers<T> c = decoupled(omega);
  for (Index k = 0; k < 2; ++k) {
    const FieldResponse<T> answer = cantilever_answer(c.kappa[k], 1, tip_ratio_);
    const Pole<T> pole(answer);
    const LiftedEntry<T> keep = kept(pole, answer.phi);
    const Rows right = loads(omega, c.phi[k], Complex(0, 1)), left = loads(omega, c.phi[k], Complex(0, -1));
    Eigen::Matrix<Complex, 2, 2> regular;
    regular << pole.regular11, pole.regular12, pole.regular12, pole.regular22;
    const Index at = first + k;
    to.matrix.topLeftCorner<body_coordinates, body_coordinates>() -= left.transpose() * regular * right;
    to.matrix(at, at) = keep.own;
    to.matrix.row(at).head<body_coordinates>() = keep.right * (pole.e1 * right.row(0) + pole.e2 * right.row(1));
    to.matrix.col(at).head<body_coordinates>() = keep.left * (pole.e1 * left.row(0) + pole.e2 * left.row(1)).transpose();
    to.poles_below[static_cast<std::size_t>(at)] = own_poles_below(keep.own, c.kappa[k], answer.phi);
  }
}

// ∫ψ of each cantilever is the first row of its answer; the part along e is −√s x (pole.h).
Eigen::Vector2cd BeamAppendage::first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const {
  const Cantilevers<double> c = decoupled(omega);
  const double weight = beam_.line_density * beam_.length * beam_.length * std::sqrt(beam_.length);
  Eigen::Vector2cd moment = Eigen::Vector2cd::Zero();
  for (Index k = 0; k < 2; ++k) {
    const FieldResponse<double> answer = cantilever_answer(c.kappa[k], 1, tip_ratio_);
    const Complex integral = weight * first_of_answer(answer, own(k), loads(omega, c.phi[k], Complex(0, 1)) * body);
    moment(0) += c.phi[k][0] * integral;
    moment(1) += Complex(0, -1) * c.phi[k][1] * integral;  // Y = −jη
  }
  return moment;
}

std::vector<Outline> BeamAppendage::outlines() const {
  Outline o{beam_.upward ? "beam, upward" : "beam, downward", {}};
  for (Index i = 0; i < points_of_a_beam; ++i) {
    o.points.emplace_back(0, 0, beam_.root_height + beam_.way() * beam_.length * static_cast<double>(i) / (points_of_a_beam - 1));
  }
  return {o};
}

// The load in direction e over φ is −√s x/a, finite at a pole; there the answer itself is taken beside it.
std::vector<ComplexMatrix> BeamAppendage::displaced(double omega, const ComplexVector& body, const ComplexVector& own) const {
  std::vector<double> stations;
  for (Index i = 0; i < points_of_a_beam; ++i) stations.push_back(static_cast<double>(i) / (points_of_a_beam - 1));
  const Cantilevers<double> c = decoupled(omega);
  ComplexMatrix d = ComplexMatrix::Zero(3, points_of_a_beam);
  for (Index k = 0; k < 2; ++k) {
    double kappa = c.kappa[k];
    FieldResponse<double> answer = cantilever_answer(kappa, 1, tip_ratio_);
    const Pole<double> pole(answer);
    const double border = kept(pole, answer.phi).left;
    constexpr double beside = 1e-7;
    if (std::abs(answer.phi) < beside) {
      kappa *= 1 + 100 * beside;
      answer = cantilever_answer(kappa, 1, tip_ratio_);
    }
    const Eigen::Vector2cd load = loads(omega, c.phi[k], Complex(0, 1)) * body;
    const Vector along = answer.phi * cantilever_shape(kappa, 1, tip_ratio_, pole.e1, pole.e2, stations);
    const Vector across = cantilever_shape(kappa, 1, tip_ratio_, -pole.e2, pole.e1, stations);
    const ComplexVector psi =
        (-border * own(k) / pole.a) * along.cast<Complex>() + (-pole.e2 * load(0) + pole.e1 * load(1)) * across.cast<Complex>();
    const double back = std::pow(beam_.length, 1.5);  // ψ of unit length, for loads l^(5/2) ρφᵀN: l⁴ ψ in all
    d.row(0) += back * c.phi[k][0] * psi.transpose();
    d.row(1) += back * c.phi[k][1] * Complex(0, -1) * psi.transpose();  // Y = −jη
  }
  return {d};
}

}  // namespace gyromode
