#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode::dense {

/// M, G, K of a component (n × n); with a partition the first `split` coordinates are in phase.
struct SingularSystem {
  Matrix mass, gyroscopic, stiffness;
  Index split = -1;

  Index size() const { return mass.rows(); }
};

/// Exact removal of the zero roots of a singular system (Routh's ignorable coordinates), without a change to normal
/// coordinates, so that every entry keeps its own accuracy.
///
/// Let N span null(K). Directions N₀ ⊂ null(K) with N₀ᵀGN = 0 have the momenta N₀ᵀ(Mq̇ + Gq), which vanish in every
/// motion e^{λt} with λ ≠ 0. With q = C c + N₀a, N₀ᵀMC = 0, M₀ = N₀ᵀMN₀, A = N₀ᵀGC:
///     λ a = −M₀⁻¹A c,   CᵀMC c̈ + CᵀGC ċ + (CᵀKC + AᵀM₀⁻¹A) c = 0.
/// C is E − N₀M₀⁻¹N₀ᵀME with unit vectors E, so that CᵀKC is a part of K as it is given. Where AᵀM₀⁻¹A is large beside
/// that part, the columns of E are combined until A has as few columns as rows: what is small stays apart from what is
/// large. Each step takes away dim N₀ pairs of zero roots; it is repeated while the smaller system is singular in that
/// way. What is left of null(K), N_g with N_gᵀGN_g regular (dimension 2s), carries s semisimple pairs of zero roots,
/// and is handed to the solver. Zero pairs in all: Σ dim N₀ + s = r − s of theory (T10). Ranks are decided entry by
/// entry (RankedFactor, RankedSkew).
struct Deflation {
  struct Step {
    Matrix c;      ///< n × n′
    Matrix n0;     ///< n × r₀
    Matrix rates;  ///< M₀⁻¹A, r₀ × n′
  };
  SingularSystem reduced;
  Matrix gyroscopic_null;  ///< N_g, n′ × 2s; with a partition the first s columns lie in the first group
  std::vector<Step> steps;
  Index zero_pairs = 0;
  Index ignorable = 0;       ///< Σ dim N₀, by which n₋(H) of the reduced system falls short of that of the whole (Haynsworth)
  Index negative_first = 0;  ///< n₋ of the reduced stiffness, in the first group where there is a partition
  Index negative_second = 0;
  bool doubtful = false;  ///< a rank that another program could decide otherwise

  Index negative() const { return negative_first + negative_second; }
  /// Shapes of the full system from those of the reduced one (columns), each with its root λ (theory: X e^{λt}).
  ComplexMatrix expand(const ComplexMatrix& shapes, const ComplexVector& lambda) const;
};

Deflation deflate(SingularSystem system);

}  // namespace gyromode::dense
