#include "gyromode/appendage/cable.h"

#include <cmath>

namespace gyromode {

double Cable::first_moment() const {
  const double reach = radius + length;
  return tip_mass * reach + 0.5 * line_density * length * (reach + radius);
}

CableImpedance::CableImpedance(const Cable& cable, double spin)
    : cable_(cable), spin_(spin), tension_(spin * spin * cable.first_moment()), reach_(cable.radius + cable.length),
      tip_mass_ratio_(cable.tip_mass / (cable.line_density * reach_)), unit_(reach_ * std::sqrt(1 + 2 * tip_mass_ratio_)), z_root_(cable.radius / unit_) {}

CableImpedance::Fields CableImpedance::fields(double omega) const {
  const double lambda = (omega / spin_) * (omega / spin_);
  return {wire_field(1 + lambda, z_root_, tip_mass_ratio_), wire_field(lambda, z_root_, tip_mass_ratio_)};
}

HubMatrix CableImpedance::at(double omega) const {
  const Complex j(0, 1);
  const double a = cable_.radius;
  const double h = cable_.height;
  const double m0 = cable_.mass();
  const double p = omega * omega + spin_ * spin_;
  const double t = 2 * omega * spin_;
  const Fields field = fields(omega);
  const double chi_in_plane = field.in_plane.chi / unit_;
  const double chi_out_of_plane = field.out_of_plane.chi / unit_;
  // Root motion radial, tangential, axial: −R, −V, −W on the diagonal and −jB between the first two.
  const double v = tension_ * chi_in_plane;
  const double w = tension_ * chi_out_of_plane;
  const double b = t * v / p;
  const double inertia = (omega - spin_) * (omega + spin_);
  const double r = (inertia * inertia * m0 + t * t * v / p) / p;
  HubMatrix local = HubMatrix::Zero();  // axes (e_r, e_t, e_3) of the cable, upper triangle
  local(0, 0) = -r;
  local(0, 1) = -j * b;
  local(0, 3) = j * (h * b);
  local(0, 4) = -h * r;
  local(0, 5) = -j * (a * b);
  local(1, 1) = -v;
  local(1, 3) = h * v;
  local(1, 4) = j * (h * b);
  local(1, 5) = -a * v;
  local(2, 2) = -w;
  local(2, 4) = a * w;
  local(3, 3) = -h * h * v;
  local(3, 4) = -j * (h * h * b);
  local(3, 5) = a * h * v - 0.5 * h * tension_;
  local(4, 4) = -h * h * r + a * tension_ * (1 - a * chi_out_of_plane);
  local(4, 5) = -j * (a * h * b);
  local(5, 5) = a * tension_ * (1 - a * chi_in_plane);
  for (int row = 0; row < 6; ++row) {
    for (int column = row + 1; column < 6; ++column) local(column, row) = std::conj(local(row, column));
  }
  Eigen::Matrix3d turn;
  turn << std::cos(cable_.azimuth), std::sin(cable_.azimuth), 0, -std::sin(cable_.azimuth), std::cos(cable_.azimuth), 0, 0, 0, 1;
  Eigen::Matrix<double, 6, 6> q = Eigen::Matrix<double, 6, 6>::Zero();
  q.topLeftCorner<3, 3>() = q.bottomRightCorner<3, 3>() = turn;
  return q.transpose() * local * q;
}

Index CableImpedance::fixed_root_negative(double omega) const {
  const Fields field = fields(omega);
  return field.in_plane.zeros + field.out_of_plane.zeros;
}

}  // namespace gyromode
