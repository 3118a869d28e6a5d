#pragma once

#include "gyromode/base/sparse_matrix.h"
#include "gyromode/sweep/campbell.h"

#include <functional>
#include <vector>

namespace gyromode {

/// A family of matrices too large to be held in full, M q̈ + ΩG₁ q̇ + (K₀ + Ω²K₂) q = 0, as lower triangles, n × n, and
/// what solves it at a spin.
struct LargeFamily {
  SparseMatrix mass;                     ///< M
  SparseMatrix gyroscopic_per_spin;      ///< G₁
  SparseMatrix stiffness;                ///< K₀
  SparseMatrix stiffness_per_spin2;      ///< K₂
  std::vector<OrbitCoordinates> places;  ///< whose orbits say how a mode whirls
  /// At one spin, with the certificate of the whole.
  std::function<ModesResult(double spin, const ModesOptions& options)> modes;
};

/// Frequencies over the spin: at every spin asked for those of the family itself, with their certificates; between
/// them, to follow branches and to find where they meet, those of its projection on all shapes found. How far the
/// projection is off is seen at the spins solved last, before their shapes are taken into it, and is in its errors.
/// @throws as campbell() of a SpinSource
Campbell campbell(const LargeFamily& family, const CampbellOptions& options);

}  // namespace gyromode
