#include "gyromode/appendage/cable.h"

#include "gyromode/appendage/row_kinds.h"
#include "gyromode/base/rounding.h"

#include <cmath>

namespace gyromode {

CableGroup::CableGroup(std::vector<Cable> cables, double spin) : cables_(std::move(cables)), spin_(spin), one_(cables_.front()) {
  tip_mass_ratio_ = one_.tip_mass / (one_.line_density * one_.reach());
  unit_ = one_.reach() * std::sqrt(1 + 2 * tip_mass_ratio_);
  z_root_ = one_.radius / unit_;
  Matrix in_plane(count(), 5), out_of_plane(count(), 3);
  for (Index i = 0; i < count(); ++i) {
    const Cable& c = cables_[static_cast<std::size_t>(i)];
    const Eigen::Vector3d e = c.direction();
    in_plane.row(i) << -e(1), e(0), -c.height * e(1), c.height * e(0), 1;
    out_of_plane.row(i) << -e(1), e(0), 1;
  }
  in_plane_ = patterns(in_plane);
  out_of_plane_ = patterns(out_of_plane);
}

MassProperties CableGroup::rigid() const {
  MassProperties all;
  for (const Cable& c : cables_) {
    const Eigen::Vector3d e = c.direction();
    const Eigen::Vector3d root(0, 0, c.height);
    MassProperties wire;
    wire.mass = c.mass();
    wire.first = c.first_moment() * e + c.mass() * root;
    wire.second = c.second_moment() * e * e.transpose() + c.first_moment() * (e * root.transpose() + root * e.transpose()) +
                  c.mass() * root * root.transpose();
    all += wire;
  }
  return all;
}

// With I0 = ∫Φ dm, I1 = ∫rΦ dm and the factor of Φ left open:
//   in plane, loads (U, φ3):          Q = [I0/p, ωI1/p; ·, aI1],           det Q = Φ I1 S Ω²/p²,   lump = [m0/p, ωS/p; ·, I]
//   out of plane, loads (ξ3, θ_t):    Q = [I0, −ωaI0; ·, (ω² − Ω²)aI1],    det Q = −Φ a I0 S Ω²,   lump = [m0, −ωS; ·, (ω² − Ω²)I]
template <class T>
CableGroup::Answers<T> CableGroup::answers(const T& omega) const {
  const T ratio = omega / spin_;
  const T lambda = ratio * ratio;
  Answers<T> found{{}, {}, {}, {}, wire_fields(lambda, z_root_, tip_mass_ratio_)};
  const double line = one_.line_density * unit_;
  const double a = one_.radius;
  const double m0 = one_.mass();
  const double s = one_.first_moment();
  const double inertia = one_.second_moment();
  const double square = spin_ * spin_;
  const T p = omega * omega + square;
  const T difference = (omega - spin_) * (omega + spin_);
  const T v0 = line * found.field[0].force, v1 = line * unit_ * found.field[0].moment;
  const T w0 = line * found.field[1].force, w1 = line * unit_ * found.field[1].moment;
  const T root_p = std::sqrt(p);
  const double root_m = std::sqrt(m0);
  found.in_units[0] = root_m / root_p;
  found.in_units[1] = root_m * one_.reach();
  found.out_units[0] = root_m;
  found.out_units[1] = root_m * one_.reach() * root_p;
  found.in_plane =
      FieldResponse<T>{found.field[0].value, v0 / p, omega * v1 / p, a * v1, v1 * s * square / (p * p), m0 / p, omega * s / p, T(inertia)}
          .scaled(1.0 / found.in_units[0], 1.0 / found.in_units[1]);
  found.out_of_plane = FieldResponse<T>{found.field[1].value, w0,    -omega * a * w0, difference * a * w1,
                                        -a * w0 * s * square, T(m0), -omega * s,      difference * inertia}
                           .scaled(1.0 / found.out_units[0], 1.0 / found.out_units[1]);
  return found;
}

template CableGroup::Answers<double> CableGroup::answers(const double& omega) const;

namespace {

// Rows that the features of U and φ3 multiply: Bξ, N(θ2, −θ1), φ3.
template <class T>
Eigen::Matrix<Complex, 5, body_coordinates> in_plane_rows(const SpinOperators<T>& f) {
  Eigen::Matrix<Complex, 5, body_coordinates> r = Eigen::Matrix<Complex, 5, body_coordinates>::Zero();
  r(0, 0) = r(1, 1) = f.omega;
  r(0, 1) = f.j * f.spin;
  r(1, 0) = -f.j * f.spin;
  r(2, 4) = f.p;
  r(2, 3) = -f.j * f.t;
  r(3, 4) = -f.j * f.t;
  r(3, 3) = -f.p;
  r(4, 5) = 1;
  return r;
}

}  // namespace

// Σ e_t ∫u dm over the wires, pattern by pattern and motion by motion of the body, so that in phase and in quadrature
// stay apart: features 1 and 2 are e_t.
Eigen::Vector2cd CableGroup::first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const {
  const Answers<double> a = answers(omega);
  const Pole<double> pole(a.in_plane);
  const double border = kept(pole, a.in_plane.phi).left;
  const auto motions = in_plane_motions(omega, body);
  Eigen::Vector2cd moment = Eigen::Vector2cd::Zero();
  for (Index q = 0; q < in_plane_.coupled; ++q)
    moment -= a.in_units[0] * border * pole.e1 * own(q) * in_plane_.response.row(q).head<2>().transpose();
  for (Index k = 0; k < 5; ++k) {
    const double answer = k < 4 ? a.in_units[0] * pole.regular11 : a.in_units[1] * pole.regular12;
    moment += a.in_units[0] * answer * motions(k) * in_plane_.gram.col(k).head<2>();
  }
  return moment;
}

Eigen::Matrix<Complex, 5, 1> CableGroup::in_plane_motions(double omega, const ComplexVector& body) const {
  return in_plane_rows(SpinOperators<double>(omega, spin_, Complex(0, 1))) * body;
}

// U = e_tᵀ(Bξ + hN(θ2, −θ1)) and θ_t.
CableGroup::Loads CableGroup::loads_on(const Cable& c, double omega, const ComplexVector& body) const {
  const auto m = in_plane_motions(omega, body);
  const Eigen::Vector3d e = c.direction();
  return {-e(1) * (m(0) + c.height * m(2)) + e(0) * (m(1) + c.height * m(3)), -e(1) * body(3) + e(0) * body(4)};
}

namespace {

// Rows that the features of θ_t and ξ3 multiply: θ1, θ2, ξ3.
Eigen::Matrix<Complex, 3, body_coordinates> out_of_plane_rows() {
  Eigen::Matrix<Complex, 3, body_coordinates> r = Eigen::Matrix<Complex, 3, body_coordinates>::Zero();
  r(0, 3) = r(1, 4) = r(2, 2) = 1;
  return r;
}

Index own_poles_below(double own, Index zeros) { return zeros - (own < 0 ? 1 : 0); }
Index own_poles_below(const Complex&, Index) { return 0; }

// The share of one field in all its patterns; loads(l, k) tells whether feature k belongs to load l.
template <class T, int features>
void add_field(const FieldResponse<T>& answer, const T (&units)[2], Index zeros, const Patterns& patterns,
               const Eigen::Matrix<double, 2, features>& loads, Eigen::Matrix<Complex, features, body_coordinates> right,
               Eigen::Matrix<Complex, features, body_coordinates> left, Lifted& to, Index first) {
  for (int i = 0; i < features; ++i) {
    right.row(i) *= units[loads(0, i) != 0 ? 0 : 1];
    left.row(i) *= units[loads(0, i) != 0 ? 0 : 1];
  }
  const Pole<T> pole(answer);
  const LiftedEntry<T> keep = kept(pole, answer.phi);
  // − Wᵀ regular W summed over the cables: feature by feature with the Gram matrix.
  Eigen::Matrix<Complex, features, features> middle;
  for (int i = 0; i < features; ++i) {
    for (int k = 0; k < features; ++k) {
      const T regular =
          loads(0, i) != 0 ? (loads(0, k) != 0 ? pole.regular11 : pole.regular12) : (loads(0, k) != 0 ? pole.regular12 : pole.regular22);
      middle(i, k) = -regular * patterns.gram(i, k);
    }
  }
  to.matrix.topLeftCorner<body_coordinates, body_coordinates>() += left.transpose() * middle * right;
  for (Index q = 0; q < patterns.vectors.cols(); ++q) {
    const Index at = first + q;
    to.matrix(at, at) = keep.own;
    to.poles_below[static_cast<std::size_t>(at)] = own_poles_below(keep.own, zeros);
    if (q >= patterns.coupled) continue;
    Eigen::Matrix<Complex, 1, features> weight;
    for (int i = 0; i < features; ++i) weight(i) = (loads(0, i) != 0 ? pole.e1 : pole.e2) * patterns.response(q, i);
    to.matrix.row(at).head<body_coordinates>() = keep.right * weight * right;
    to.matrix.col(at).head<body_coordinates>() = keep.left * (weight * left).transpose();
  }
}

const Eigen::Matrix<double, 2, 5> in_plane_loads = (Eigen::Matrix<double, 2, 5>() << 1, 1, 1, 1, 0, 0, 0, 0, 0, 1).finished();
const Eigen::Matrix<double, 2, 3> out_of_plane_loads = (Eigen::Matrix<double, 2, 3>() << 0, 0, 1, 1, 1, 0).finished();

// The kinds of in_plane_rows() and out_of_plane_rows().
constexpr std::array<RowKinds, 5> in_plane_kinds = [] {
  constexpr EntryKind o = EntryKind::none, r = EntryKind::real, i = EntryKind::imaginary;
  return std::array<RowKinds, 5>{{{r, i, o, o, o, o}, {i, r, o, o, o, o}, {o, o, o, i, r, o}, {o, o, o, r, i, o}, {o, o, o, o, o, r}}};
}();
constexpr std::array<RowKinds, 3> out_of_plane_kinds = [] {
  constexpr EntryKind o = EntryKind::none, r = EntryKind::real;
  return std::array<RowKinds, 3>{{{o, o, o, r, o, o}, {o, o, o, o, r, o}, {o, o, r, o, o, o}}};
}();

// Features meet where their Gram matrix says so; a pattern meets the features that it answers to, of those that reach
// its kept coordinate; patterns that answer to none are equal.
template <std::size_t features>
void couple_field(const Patterns& patterns, const std::array<RowKinds, features>& rows, const std::array<bool, features>& reaches,
                  Couplings& to, Index first) {
  for (std::size_t f = 0; f < features; ++f) {
    for (std::size_t g = 0; g < features; ++g) {
      if (patterns.gram(static_cast<Index>(f), static_cast<Index>(g)) != 0) add_product(to, rows[f], rows[g]);
    }
    for (Index q = 0; q < patterns.coupled; ++q) {
      if (reaches[f] && patterns.response(q, static_cast<Index>(f)) != 0) add_row(to, first + q, rows[f]);
    }
  }
  for (Index q = patterns.coupled + 1; q < patterns.vectors.cols(); ++q) to.equal(first + patterns.coupled, first + q);
}

}  // namespace

// Out of plane a wire hinged on the axis (a = 0) is not moved by θ_t: Q has the one entry I0.
void CableGroup::couple(Couplings& to, Index first) const {
  const bool turned = one_.radius != 0;
  couple_field<5>(in_plane_, in_plane_kinds, {true, true, true, true, true}, to, first);
  couple_field<3>(out_of_plane_, out_of_plane_kinds, {turned, turned, true}, to, first + count());
}

template <class T>
void CableGroup::add_to(const T& omega, Lifted& to, Index first) const {
  const Answers<T> a = answers(omega);
  const SpinOperators<T> plus(omega, spin_, Complex(0, 1)), minus(omega, spin_, Complex(0, -1));
  add_field<T, 5>(a.in_plane, a.in_units, a.field[0].zeros, in_plane_, in_plane_loads, in_plane_rows(plus), in_plane_rows(minus), to,
                  first);
  add_field<T, 3>(a.out_of_plane, a.out_units, a.field[1].zeros, out_of_plane_, out_of_plane_loads, out_of_plane_rows(),
                  out_of_plane_rows(), to, first + count());
}

}  // namespace gyromode
