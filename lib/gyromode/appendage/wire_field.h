#pragma once

#include "gyromode/base/types.h"

#include <array>
#include <vector>

namespace gyromode {

/// The deflection of a spinning wire, mass loaded at its tip: Legendre's equation of any degree,
///     ((1 − z²) Φ′)′ + 2λ Φ = 0   on [z_a, z_t],   0 ≤ z_a < z_t ≤ 1,   2λ = ν(ν + 1),
/// with z_t = 1/c, c = √(1 + 2μ), μ the tip mass over ρb. At the tip Φ is regular (μ = 0: Φ = P_ν) or Φ′ = cλΦ. All up
/// to one common factor.
template <class T>
struct WireField {
  T value{};        ///< Φ(z_a), zero at a fixed-root frequency
  T slope{};        ///< (1 − z_a²) Φ′(z_a) = 2λ · force
  T force{};        ///< ∫ Φ dz + (μ/c) Φ(z_t): first integral of the motion
  T moment{};       ///< ∫ z Φ dz + (μ/c²) Φ(z_t)
  T tip{};          ///< Φ(z_t)
  Index zeros = 0;  ///< of Φ in the open interval (z_a, z_t), by Sturm the number of fixed-root frequencies below; real λ only
};

/// The fields of 1 + λ and of λ in one march: in plane and out of plane for λ = ω²/Ω². λ may be negative or complex
/// (growing motion). Taylor series from tip to root, in steps that turn the phase by less than π, so that sign changes
/// count zeros exactly: no ν is formed, and integer degrees and vanishing tip masses are nothing special. Errors grow
/// as the phase: 1e-15 of the larger of value and slope for ν < 4, 2e-14 at 30, 1e-12 at 100. Near λ = 0 the value in
/// plane has small relative errors even where z_a → 0 makes it vanish.
std::array<WireField<double>, 2> wire_fields(double lambda, double z_root, double tip_mass_ratio);
std::array<WireField<Complex>, 2> wire_fields(Complex lambda, double z_root, double tip_mass_ratio);

/// Φ along the wire, at the given z (descending, from z_t to z_a or part of it), with Φ(z_t) = 1.
template <class T>
std::vector<T> wire_shape(const T& lambda, const std::vector<double>& z, double tip_mass_ratio);

}  // namespace gyromode
