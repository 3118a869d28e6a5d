#pragma once

#include "gyromode/structure/structure.h"
#include "gyromode/system/system.h"

#include <optional>
#include <string>

namespace gyromode::dense {

/// A real symmetric n × n matrix W, independent of the frequency, whose eigenvalues are the ω² of M q̈ + G q̇ + K q = 0,
/// each once: the transformation of the most general system that Boland & Janssens 1979 leave to a later paper
/// (Conclusion), where K ≥ 0, and the one of the quadrature class. With u = displacement · q + velocity · q̇ every
/// motion obeys ü = −W u; a mode (ω, X) has W u = ω²u for u = (displacement + jω velocity) X.
struct ConstantForm {
  Matrix w;                       ///< n × n; block-diagonal over the components of the system, in their order
  Matrix displacement, velocity;  ///< n × n each
  /// Of a system that is one component without partition, K ≥ 0: Z = QTQᵀ (theory (T8)), Q orthogonal 2n × 2n, D
  /// bidiagonal n × n with Dᵀ D = W.
  std::optional<Matrix> orthogonal, bidiagonal;
  std::string solver;
};

/// Per component: W of (T5) where there is a quadrature partition, visible or hidden, with a stiffness ≥ 0 in one
/// group; else DᵀD of (T8) where K ≥ 0. Negative eigenvalues of W are divergence; zero ones zero modes. Throws
/// NotApplicable where there is no such matrix: K indefinite without a partition, or indefinite in both groups.
ConstantForm constant_form(const System& system, const Structure& structure);

}  // namespace gyromode::dense
