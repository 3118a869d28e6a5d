#pragma once

#include "gyromode/system/system.h"

#include <cstdint>
#include <string>

namespace gyromode::support {

/// A seeded system of the quadrature class, and the same in coordinates that hide it: q = S q′ with S random of
/// condition up to 1e6. Kinds: generic; axisymmetric rotors (every root double at rest); K with repeated eigenvalues;
/// several copies of one system; sparse couplings with K of any sign; weak gyroscopic terms.
struct Scrambled {
  System plain, hidden;
  double condition = 1;   ///< of S
  bool repeated = false;  ///< eigenvalues of (K, M) are: a perturbed G may then have a symmetry of its own
  std::string description;
};
/// `order`: the largest n, at least 4; `most`: the largest condition.
Scrambled scrambled_system(std::uint64_t seed, Index order, double most);

/// G with a random skew matrix of `size`·‖G‖ added (Frobenius norms).
System with_perturbed_gyroscopic(const System& s, double size, std::uint64_t seed);

}  // namespace gyromode::support
