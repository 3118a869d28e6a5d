#pragma once

#include "gyromode/spectrum/result.h"
#include "gyromode/spectrum/window.h"
#include "gyromode/sweep/whirl.h"
#include "gyromode/system/spin_family.h"

#include <optional>
#include <vector>

namespace gyromode {

/// A speed Ω at which a mode has the frequency mΩ.
struct CriticalSpeed {
  double speed = 0;            ///< Ω, rad per unit of time, > 0
  double multiple = 1;         ///< of the speed, its frequency in the axes of the model
  double residual = 0;         ///< ‖(K₀ − Ω²B)X‖ / ((‖K₀‖ + Ω²‖B‖)‖X‖), B = m²M − jmG₁ − K₂
  double error_bound = 0;      ///< on |δΩ|, to first order
  std::optional<Whirl> whirl;  ///< where the model has stations; of an order in fixed axes, in those
  ComplexVector shape;         ///< X, n, largest entry 1
};

/// What is asked.
struct CriticalOptions {
  double order = 1;             ///< m, ≥ 0: of an excitation mΩ in the axes of the model
  Window window;                ///< of speeds
  std::optional<Index> lowest;  ///< only so many
};

/// All critical speeds of a window, from one pencil.
struct CriticalSpeeds {
  double order = 1;                   ///< as asked
  bool in_fixed_axes = false;         ///< the order is one of fixed axes, the model in turning ones
  Index other_way = 0;                ///< roots in the range whose places go round the other way alone, so that they have another order
  std::vector<CriticalSpeed> speeds;  ///< ascending
  Index not_physical = 0;             ///< roots with Ω² < 0, or not real
  Coverage coverage;                  ///< complete: counted by factorisations of K₀ − Ω²B
};

/// Whether two speeds, one after the other, are one within their errors.
bool coincide(const CriticalSpeed& a, const CriticalSpeed& b);
/// Only the lowest so many, and those that coincide with the last of them.
void keep_lowest(CriticalSpeeds& all, Index count);

/// Speeds at which H(mΩ) is singular: K₀X = Ω²(m²M − jmG₁ − K₂)X (theory (T13)), of a family with G = ΩG₁, K = K₀ +
/// Ω²K₂, by the eigenvalues of that Hermitian pencil: real symmetric where M, G, K have a quadrature partition. K₀ > 0:
/// definite, and counted; K₀ ≥ 0: without its null space, on which Ω = 0; K₀ indefinite: its real roots, counted where
/// their signs add up. Order 0: where K₀ + Ω²K₂ is singular, the thresholds of divergence. Throws
/// NotApplicable where G does not go with the speed alone, but for order 0.
CriticalSpeeds critical_speeds(const SpinFamily& family, const CriticalOptions& options,
                               const std::vector<OrbitCoordinates>& stations = {});

}  // namespace gyromode
