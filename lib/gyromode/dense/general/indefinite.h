#pragma once

#include "gyromode/dense/general/normal_form.h"
#include "gyromode/spectrum/unstable_roots.h"

#include <vector>

namespace gyromode::dense {

/// Roots of a general system with K indefinite, in mass-normalised coordinates.
struct IndefiniteModes {
  Vector omega;          ///< undamped modes, ω > 0 ascending, exactly undamped
  ComplexMatrix shapes;  ///< n × m
  UnstableRoots unstable;
};

/// All roots of z̈ + Γż + kz = 0, k symmetric and indefinite, with the Hamiltonian structure kept (theory §3c).
///
/// In first order, in units of time 1/γ, w = (z, ż/γ): 𝒮 w′ = −𝓔 w, 𝒮 = [Γ/γ 1; −1 0] skew, 𝓔 = diag(k/γ², 1)
/// symmetric. The eigenvectors w_i of the plain 2n × 2n matrix pair as w₋ᴴ𝒮w ≠ 0 only for λ₋ = −λ̄. That pairing, not a
/// threshold on real parts, finds the groups of roots that can meet on the imaginary axis; each group is projected on
/// the Hermitian pencil 𝓔 − ω(−j𝒮), whose roots are real or in conjugate pairs exactly. A group of one, or of one
/// energy sign, therefore comes out exactly undamped; in a group of mixed signs each computed root is real or joined
/// with its nearest conjugate. Roots far below the largest are projected and solved again. `gyroscopic_null`: null
/// vectors of k with regular N_gᵀΓN_g (n × 2s), or none; their zero roots are removed first.
IndefiniteModes indefinite_modes(const NormalForm& form, const Matrix& gyroscopic_null);

/// The same from eigenpairs found elsewhere (λ, z) for all 2n roots: the classical companion form uses it.
IndefiniteModes resolve_roots(const NormalForm& form, const ComplexVector& lambda, const ComplexMatrix& z);

}  // namespace gyromode::dense
