#pragma once

#include "gyromode/system/system.h"

#include <cstdint>
#include <random>
#include <string>

namespace gyromode::support {

/// A seeded random system of order 1 … 12 from every class that the solvers distinguish: quadrature or general; K
/// positive definite, semidefinite, indefinite, negative definite or zero; generic, clustered, graded, whirl-pair,
/// nearly unstable and exactly defective spectra; strong and weak gyroscopic terms; unit scales 2⁻³⁰, 1, 2³⁰. The same
/// seed gives the same system on every machine.
struct RandomSystem {
  Matrix mass, gyroscopic, stiffness;
  std::string description;  ///< what was drawn, for messages

  System system() const { return System(mass, gyroscopic, stiffness); }
};

RandomSystem random_system(std::uint64_t seed);

}  // namespace gyromode::support
