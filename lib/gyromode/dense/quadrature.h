#pragma once

#include "gyromode/lapack/types.h"

#include <optional>
#include <string>
#include <vector>

namespace gyromode::dense {

/// The quadrature class in mass-normalised coordinates (theory (T4)):
///     ẍ + b ẏ + k₁ x = 0,   ÿ − bᵀ ẋ + k₂ y = 0,    b p × r.
/// Roots f_i with k_i = f_i f_iᵀ, p × q₁ and r × q₂, are given where a block is positive semidefinite (q < its order only where the null
/// space is gyroscopically coupled; see Deflation).
struct QuadratureForm {
  Matrix b;
  Matrix k1, k2;
  std::optional<Matrix> f1, f2;
  Matrix null1, null2;  ///< gyroscopically coupled null vectors of k₁ (p × s) and k₂ (r × s), orthonormal; s = 0 for a regular K
};

/// Motions X = (x, −j y) e^{jωt} with real x (p × m) and y (r × m), ω > 0 ascending; and the roots off the imaginary axis.
struct QuadratureModes {
  Vector omega;
  Matrix x, y;
  std::vector<double> divergence;  ///< σ > 0 of pairs ±σ
  std::vector<Complex> flutter;    ///< σ + jω, σ, ω > 0, of quadruples
  ComplexMatrix flutter_shapes;             ///< n × quadruples: (x, ẏ/λ) of X e^{λt}
  std::string path;
};

/// All roots of the form, by what its blocks allow:
///   a block ≥ 0      W of (T5), real symmetric n × n; the singular values of C, W = CCᵀ, where small frequencies ask for it;
///   both indefinite  P of (T6), real n × n, its close roots separated by the self-adjoint form that P has.
/// Frequencies are relative to the unit of time of the form: scale it so that ‖k‖ is near 1.
QuadratureModes quadrature_modes(const QuadratureForm& form);

}  // namespace gyromode::dense
