// Modes of a rotating mass on springs, and of a satellite with two wires, by the installed package.
#include <gyromode/gyromode.h>

#include <cstdio>
#include <iostream>

int main() {
  const double spin = 100;  // rad/s
  const gyromode::Matrix mass = 0.2 * gyromode::Matrix::Identity(2, 2);
  gyromode::Matrix per_spin(2, 2);
  per_spin << 0, -0.4, 0.4, 0;
  gyromode::Matrix stiffness(2, 2);
  stiffness << 40e3, 0, 0, 200e3;
  const gyromode::Model rotor(gyromode::SpinFamily{mass, gyromode::Matrix::Zero(2, 2), per_spin, stiffness, -mass, {"x", "y"}}, spin);
  gyromode::ModesOptions all;
  all.shapes = true;
  const gyromode::ModesResult result = rotor.modes(all);
  std::cout << result << result.shapes() << "\n";

  const gyromode::Body hub{270, Eigen::Vector3d(85, 100, 120).asDiagonal()};
  gyromode::Cable wire;
  wire.radius = 0.8;
  wire.length = 20;
  wire.line_density = 0.03;
  gyromode::Cable opposite = wire;
  opposite.azimuth = 3.14159265358979323846;
  gyromode::ModesOptions lowest;
  lowest.lowest = 5;
  const gyromode::Model satellite(gyromode::Spacecraft(1.05, hub, {wire, opposite}));
  const gyromode::ModesResult of_satellite = satellite.modes(lowest);
  for (const double omega : of_satellite.frequencies()) std::printf("%.12g rad/s\n", omega);
  std::cout << gyromode::document(satellite, satellite.stability(), {}, gyromode::Format::json).substr(0, 60) << "\n";
  try {
    rotor.with({{"spinn", 1}});
    return 1;
  } catch (const gyromode::InvalidArgument&) {
  }
  return result.is_complete() && of_satellite.is_complete() && rotor.with({{"spin", 0}}).modes().frequencies().size() == 2 ? 0 : 1;
}
