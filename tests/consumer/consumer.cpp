// Modes of a rotating mass on springs, by the installed package.
#include <gyromode/modes/modes.h>

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
  return result.coverage.status == gyromode::CoverageStatus::complete ? 0 : 1;
}
