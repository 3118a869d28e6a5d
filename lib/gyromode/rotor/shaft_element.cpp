#include "gyromode/rotor/shaft_element.h"

#include "gyromode/lapack/small.h"

#include <array>
#include <cmath>

namespace gyromode {

namespace {

using Row = Eigen::RowVector4d;

// Gauss–Legendre points and weights on [0, 1].
template <int n>
struct Gauss {
  std::array<double, n> at, weight;

  Gauss() {
    Matrix jacobi = Matrix::Zero(n, n);  // of the Legendre polynomials (Golub & Welsch 1969)
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1);
    const auto e = small::symmetric_eigen(jacobi);
    for (int k = 0; k < n; ++k) {
      at[static_cast<std::size_t>(k)] = 0.5 * (1 + e.values(k));
      weight[static_cast<std::size_t>(k)] = e.vectors(0, k) * e.vectors(0, k);
    }
  }
};

const Gauss<20>& gauss() {
  static const Gauss<20> rule;
  return rule;
}

template <class Function>
auto integral(double to, Function&& f) {
  auto sum = decltype(f(0.0))(f(gauss().at[0] * to) * gauss().weight[0]);
  for (std::size_t k = 1; k < gauss().at.size(); ++k) sum += f(gauss().at[k] * to) * gauss().weight[k];
  return decltype(f(0.0))(sum * to);
}

// The unloaded piece: a bending moment c − Qz and a shear force Q, with c and Q as they follow from the ends.
class Statics {
 public:
  explicit Statics(const ShaftPiece& p) : p_(p) {
    const double l = p.length;
    // θ(l) − θ₁ = cF₀ − QF₁;  u(l) − u₁ − θ₁l = c∫(l − s)/EI − Q(∫(l − s)s/EI − S)
    Eigen::Matrix2d of_forces;
    of_forces << integral(l, [&](double s) { return flexibility(s); }), -integral(l, [&](double s) { return s * flexibility(s); }),
        integral(l, [&](double s) { return (l - s) * flexibility(s); }),
        -integral(l, [&](double s) { return (l - s) * s * flexibility(s) - shear_flexibility(s); });
    Eigen::Matrix<double, 2, 4> of_ends;
    of_ends << 0, -1, 0, 1, -1, -l, 1, 0;
    forces_ = small::solve(Matrix(of_forces), Matrix(of_ends));
  }

  double flexibility(double z) const { return 1 / (p_.material.young * p_.at(z).second_moment()); }
  double shear_flexibility(double z) const {
    if (p_.theory != ShaftTheory::timoshenko) return 0;
    const CrossSection s = p_.at(z);
    return 1 / (p_.shear_coefficient.value_or(s.shear_coefficient(p_.material.poisson())) * p_.material.shear * s.area());
  }
  Row moment(double z) const { return forces_.row(0) - z * forces_.row(1); }
  Row shear() const { return forces_.row(1); }
  Row slope(double z) const {
    return Row(0, 1, 0, 0) + integral(z, [&](double s) { return Row(moment(s) * flexibility(s)); });
  }
  Row displacement(double z) const {
    return Row(1, z, 0, 0) +
           integral(z, [&](double s) { return Row(moment(s) * ((z - s) * flexibility(s)) + shear() * shear_flexibility(s)); });
  }

 private:
  const ShaftPiece& p_;
  Eigen::Matrix<double, 2, 4> forces_;  // c and Q of the ends
};

}  // namespace

CrossSection ShaftPiece::at(double z) const {
  const double t = z / length;
  return {(1 - t) * lower.outer + t * upper.outer, (1 - t) * lower.inner + t * upper.inner};
}

ShaftElement shaft_element(const ShaftPiece& p) {
  const Statics statics(p);
  Eigen::Matrix4d mass = Eigen::Matrix4d::Zero(), rotary = mass, stiffness = mass, geometric = mass;
  for (std::size_t k = 0; k < gauss().at.size(); ++k) {
    const double z = gauss().at[k] * p.length, weight = gauss().weight[k] * p.length;
    const CrossSection s = p.at(z);
    const Row u = statics.displacement(z), theta = statics.slope(z), moment = statics.moment(z);
    const Row steepness = theta + statics.shear() * statics.shear_flexibility(z);
    mass += weight * p.material.density * s.area() * u.transpose() * u;
    rotary += weight * p.material.density * s.second_moment() * theta.transpose() * theta;
    stiffness += weight * (statics.flexibility(z) * moment.transpose() * moment +
                           statics.shear_flexibility(z) * statics.shear().transpose() * statics.shear());
    geometric += weight * steepness.transpose() * steepness;
  }
  if (p.theory != ShaftTheory::euler) mass += rotary;
  const auto symmetric = [](const Eigen::Matrix4d& a) { return Matrix(0.5 * (a + a.transpose())); };  // to the last bit
  return {symmetric(mass), symmetric(rotary), symmetric(stiffness), symmetric(geometric)};
}

}  // namespace gyromode
