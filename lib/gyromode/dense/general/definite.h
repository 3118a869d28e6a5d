#pragma once

#include "gyromode/base/types.h"

namespace gyromode::dense {

/// Undamped motions X e^{jωt}, ω > 0 ascending, X = re + j im (n × m) in mass-normalised coordinates.
struct ComplexModes {
  Vector omega;
  Matrix re;
  Matrix im;
};

/// All modes of z̈ + Γż + f fᵀ z = 0 for K ≥ 0, without a partition (theory §3a, (T8)). f is n × q with full column
/// rank; q < n only for a K whose null space N has NᵀΓN regular. The skew matrix
///     Z = [ 0  fᵀ ; −f  −Γ ]
/// of order n + q is tridiagonalised; the odd rows and even columns of T are a real bidiagonal matrix D of half the
/// order whose singular values are the frequencies, each once.
ComplexModes definite_modes(const Matrix& gamma, const Matrix& f);

/// The singular values and vectors of a skew matrix g (n × n): g X = −jωX with ω > `threshold`, ascending, X = re + j
/// im. For I q̇ + G q = 0 with I = 1 (theory §3d).
ComplexModes skew_modes(const Matrix& g, double threshold);

}  // namespace gyromode::dense
