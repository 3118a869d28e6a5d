#pragma once

#include "gyromode/system/system.h"

#include <cstdint>
#include <string>

namespace gyromode::support {

/// A seeded system that is hard to get right and known exactly: integers, and powers of two of them, so that every
/// entry is a double without rounding.
///
/// Regimes, mixed at random: strong spin (G times 2⁰ … 2³⁰), graded stiffness (entries over 2⁰ … 2⁵⁴), exactly singular
/// K, exactly defective roots (free masses in turning axes, stabilisation thresholds), several copies of one system
/// hidden by a unimodular change of coordinates, and mixed units: every coordinate in its own unit (2⁻³⁰ … 2³⁰), time
/// in another (2⁻³⁰ … 2³⁰).
///
/// `base` is the system before units were mixed, `given` after: their roots differ by the factor `time_unit` exactly.
struct HostileSystem {
  struct Matrices {
    Matrix mass, gyroscopic, stiffness;
  };
  Matrices base, given;
  double time_unit = 1;  ///< roots of `given` = time_unit · roots of `base`
  std::string description;

  System system() const { return System(given.mass, given.gyroscopic, given.stiffness); }
};

HostileSystem hostile_system(std::uint64_t seed);

}  // namespace gyromode::support
