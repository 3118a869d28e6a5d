#pragma once

#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <vector>

namespace gyromode::analytic {

/// Closed-form systems: matrices, and the frequencies that they are known to have. Each is tested at its own limits in
/// test_published.cpp.

/// J = [0 −1; 1 0].
Matrix rotation_generator();

/// Any undamped structure (M₀, K₀) seen from axes turning at Ω: M = 1₂⊗M₀, G = 2Ω J⊗M₀, K = 1₂⊗(K₀ − Ω²M₀). Frequencies
/// |ω_k − Ω| and ω_k + Ω, the first of negative energy where ω_k < Ω.
struct RotatingFrame {
  Matrix mass, stiffness;  ///< M₀, K₀
  double spin;

  System system() const;
};

/// M = 1, G = gJ, K = diag(−k₁, −k₂): stable for g > √k₁ + √k₂, ω² = [(g² − k₁ − k₂) ± √((g² − k₁ − k₂)² − 4k₁k₂)]/2.
struct StabilisedPair {
  double k1, k2, g;

  System system() const;
  std::vector<double> frequencies() const;  ///< empty where there is flutter
};

/// A rigid body spinning at Ω about axis 3 (Boland & Janssens 1979, first example): Ω and Ω√((I₃−I₁)(I₃−I₂)/(I₁I₂)).
struct SpinningBody {
  double i1, i2, i3, spin;

  System system() const;
  double nutation_squared() const;  ///< negative where the body turns over
};

/// A mass on three springs in turning axes (Friswell et al. 2010, pp. 423–429): in-plane frequencies from a
/// biquadratic, and √(Kz/m).
struct SpringMass {
  double mass, kx, ky, kz, spin;

  System system() const;
};

/// Meirovitch 1974 / Boland & Janssens 1979, Fig. 3, in first order; ω = |z − ω₀| for the roots of m A z³ − m C ω₀z² −
/// kA′z + kCω₀ = 0.
struct MeirovitchBody {
  double a_inertia, c_inertia, mass, arm, stiffness, spin;

  FirstOrderSystem system() const;
};

/// Travelling string by n sine functions (Wei & Kao 2000): M = 1/2, K = j²π²(1 − v²)/2, G = 4jkv/(j² − k²) for j + k
/// odd.
System wiresaw(Index n, double speed);

}  // namespace gyromode::analytic
