// Modes of a rotating mass on springs, and of a satellite with two wires, by the installed package.
#include <gyromode/modes/modes.h>
#include <gyromode/modes/spacecraft.h>

#include <cstdio>

int main() {
  const double spin = 100;  // rad/s
  const gyromode::Matrix mass = 0.2 * gyromode::Matrix::Identity(2, 2);
  gyromode::Matrix gyroscopic(2, 2);
  gyroscopic << 0, -0.4 * spin, 0.4 * spin, 0;
  gyromode::Matrix stiffness(2, 2);
  stiffness << 40e3 - 0.2 * spin * spin, 0, 0, 200e3 - 0.2 * spin * spin;

  const auto result = gyromode::find_modes(gyromode::System(mass, gyroscopic, stiffness));
  for (const auto& mode : result.modes) std::printf("%.12g rad/s\n", mode.omega);

  const gyromode::Body hub{270, Eigen::Vector3d(85, 100, 120).asDiagonal()};
  gyromode::Cable wire;
  wire.radius = 0.8;
  wire.length = 20;
  wire.line_density = 0.03;
  gyromode::Cable opposite = wire;
  opposite.azimuth = 3.14159265358979323846;
  gyromode::ModesOptions options;
  options.lowest = 5;
  const auto satellite = gyromode::find_modes(gyromode::Spacecraft(1.05, hub, {wire, opposite}), options);
  for (const auto& mode : satellite.modes) std::printf("%.12g rad/s\n", mode.omega);
  const bool complete = result.coverage.status == gyromode::CoverageStatus::complete && satellite.coverage.status == gyromode::CoverageStatus::complete;
  return complete ? 0 : 1;
}
