#pragma once

#include "gyromode/dense/normal_form.h"

#include <vector>

namespace gyromode::dense {

/// Null space and index of a stiffness.
struct NullBasis {
  Matrix vectors;      ///< n × r, spanning null(k); with a partition each column lies in one group
  Index first = 0;     ///< how many lie in the first group
  Index negative = 0;  ///< n₋(k)
  double error = 0;    ///< of the vectors: rounding over the distance to the other eigenvalues
};

/// Exact removal of the zero roots of a singular system (Routh's ignorable coordinates).
///
/// Let N span null(k). Directions N₀ ⊂ null(k) with N₀ᵀΓN = 0 have the conserved momenta N₀ᵀ(ż + Γz), which vanish in every motion e^{λt} with
/// λ ≠ 0. Writing z = C c + N₀ a, C ⊥ N₀:   λ a = −Γ₀c c,   Γ₀c = N₀ᵀΓC,   and c obeys the smaller gyroscopic system
///     c̈ + CᵀΓC ċ + (Cᵀk C + Γ₀cᵀΓ₀c) c = 0.
/// Each step takes away dim N₀ pairs of zero roots; it is repeated while the smaller system is singular in that way. What is left of
/// null(k), N_g with N_gᵀΓN_g regular (dimension 2s), carries s semisimple pairs of zero roots, and is handed to the solver.
/// The partition of a quadrature system is kept. Zero pairs in all: Σ dim N₀ + s = r − s of theory (T10).
struct Deflation {
  struct Step {
    Matrix c;         ///< n × n′, orthonormal
    Matrix n0;        ///< n × r₀, orthonormal
    Matrix gamma_0c;  ///< r₀ × n′
  };
  NormalForm reduced;
  Matrix gyroscopic_null;  ///< N_g, n′ × 2s, orthonormal; with a partition the first s columns lie in the first group
  std::vector<Step> steps;
  Index zero_pairs = 0;
  Index ignorable = 0;     ///< Σ dim N₀, by which n₋(H) of the reduced system falls short of that of the whole (Haynsworth)
  Index negative = 0;      ///< n₋ of the reduced stiffness
  double threshold = 0;    ///< eigenvalues of the reduced stiffness up to this are zero

  /// Eigenvalues of k below −threshold.
  Index negative_in(const Matrix& k) const;

  /// Shapes of the full system from those of the reduced one (columns), each with its root λ (theory: X e^{λt}).
  ComplexMatrix expand(const ComplexMatrix& shapes, const ComplexVector& lambda) const;
};

/// `null` is null(k) as found on the stiffness given, where its units could be taken out; null spaces of reduced systems are decided by
/// |λ| ≤ 8 n ε max(‖k‖, ‖Γ‖²).
Deflation deflate(NormalForm form, NullBasis null);

}  // namespace gyromode::dense
