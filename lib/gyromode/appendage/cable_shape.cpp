#include "gyromode/appendage/cable.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

constexpr Index points_of_a_wire = 49;

// Φ along a wire, in the factor of the field.
Vector along(double lambda, const std::vector<double>& z, double tip_mass_ratio, double tip) {
  const std::vector<double> shape = wire_shape(lambda, z, tip_mass_ratio);
  Vector phi(static_cast<Index>(shape.size()));
  for (Index k = 0; k < phi.size(); ++k) phi(k) = tip * shape[static_cast<std::size_t>(phi.size() - 1 - k)];  // from the root
  return phi;
}

}  // namespace

std::vector<double> CableGroup::stations() const {
  std::vector<double> z(static_cast<std::size_t>(points_of_a_wire));
  const double step = one_.length / (points_of_a_wire - 1) / unit_;
  for (std::size_t k = 0; k < z.size(); ++k) z[k] = z_root_ + step * static_cast<double>(z.size() - 1 - k);
  z.back() = z_root_;
  return z;
}

std::vector<Outline> CableGroup::outlines() const {
  std::vector<Outline> all;
  for (const Cable& c : cables_) {
    Outline o{fmt::format("cable at {:.4g}°", c.azimuth * 180 / EIGEN_PI), {}};
    for (Index k = 0; k < points_of_a_wire; ++k) {
      const double r = c.radius + c.length * static_cast<double>(k) / (points_of_a_wire - 1);
      o.points.push_back(r * c.direction() + Eigen::Vector3d(0, 0, c.height));
    }
    all.push_back(std::move(o));
  }
  return all;
}

// In plane u = −U/p − rφ3/ω + AΦ, out of plane w = −ξ3/ω + rθ_t + AΦ, with AΦ(a) what makes the root 0. AΦ(a) =
// cᵀ(loads); of A itself the part along e is the kept coordinate and the part across it is finite where Φ(a) = 0: c is
// a row of Q there.
std::vector<ComplexMatrix> CableGroup::displaced(double omega, const ComplexVector& body, const ComplexVector& own) const {
  const Answers<double> a = answers(omega);
  const Pole<double> in(a.in_plane), out(a.out_of_plane);
  const double in_border = kept(in, a.in_plane.phi).left;
  const double out_border = kept(out, a.out_of_plane.phi).left;
  const double p = omega * omega + spin_ * spin_;
  const double mass = one_.mass(), reach = one_.reach();
  const double tension = one_.first_moment() * spin_ * spin_;
  const std::vector<double> z = stations();
  const double lambda = omega * omega / (spin_ * spin_);
  const Vector phi_in = along(1 + lambda, z, tip_mass_ratio_, a.field[0].tip);
  const Vector phi_out = along(lambda, z, tip_mass_ratio_, a.field[1].tip);
  const ComplexVector x_in = in_plane_.vectors * own.head(count());
  const ComplexVector x_out = out_of_plane_.vectors * own.tail(count());
  std::vector<ComplexMatrix> all;
  for (Index i = 0; i < count(); ++i) {
    const Cable& c = cables_[static_cast<std::size_t>(i)];
    const Eigen::Vector3d e = c.direction();
    const auto [u, turn] = loads_on(c, omega, body);
    const double c1 = 1 / p / a.in_units[0], c2 = c.radius / omega / a.in_units[1];
    const Complex amplitude_in = -(c1 * in.e1 + c2 * in.e2) * in_border * x_in(i) / in.a +
                                 a.in_units[1] * tension / (mass * mass * reach * reach * p) * in.e1 / (in.a * omega) *
                                     (-in.e2 * a.in_units[0] * u + in.e1 * a.in_units[1] * body(5));
    const double d1 = 1 / omega / a.out_units[0], d2 = -c.radius / a.out_units[1];
    const Complex amplitude_out = -(d1 * out.e1 + d2 * out.e2) * out_border * x_out(i) / out.a +
                                  a.out_units[0] * c.radius * tension / (mass * mass * reach * reach * p) * out.e2 / (out.a * omega) *
                                      (-out.e2 * a.out_units[0] * body(2) + out.e1 * a.out_units[1] * turn);
    ComplexMatrix d(3, points_of_a_wire);
    for (Index k = 0; k < points_of_a_wire; ++k) {
      const double r = c.radius + c.length * static_cast<double>(k) / (points_of_a_wire - 1);
      const Complex across = k == 0 ? Complex(0) : -u / p - r * body(5) / omega + amplitude_in * phi_in(k);
      const Complex axial = k == 0 ? Complex(0) : -body(2) / omega + r * turn + amplitude_out * phi_out(k);
      d.col(k) << -e(1) * across, e(0) * across, axial;
    }
    all.push_back(std::move(d));
  }
  return all;
}

}  // namespace gyromode
