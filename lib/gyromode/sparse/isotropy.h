#pragma once

#include "gyromode/sparse/sparse_system.h"

#include <optional>

namespace gyromode::sparse {

/// What vibrates across the axis that its coordinates turn about, the same in every direction across it:
///     M = 1₂ ⊗ M₀,  G = 2Ω J ⊗ M₀,  K = 1₂ ⊗ (K₀ − Ω²M₀),  J = [0, −1; 1, 0],
/// to rounding of every entry. In axes that stand still it is M₀z̈ + K₀z = 0 of z = x + jy, without gyroscopic terms: of
/// every frequency s of these there are s + Ω and |s − Ω| in the axes that turn.
struct Isotropy {
  double spin = 0;          ///< Ω > 0
  std::vector<Index> x, y;  ///< the coordinates of z, n/2 each
  SparseMatrix mass;        ///< M₀, lower triangle
  SparseMatrix stiffness;   ///< K₀, lower triangle
};

/// Verified entry by entry; nothing where the system is not of that kind, or G is zero.
std::optional<Isotropy> isotropy_of(const SparseSystem& system);

}  // namespace gyromode::sparse
