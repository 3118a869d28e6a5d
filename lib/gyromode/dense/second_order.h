#pragma once

#include "gyromode/dense/impedance.h"
#include "gyromode/structure/reversing_symmetry.h"

namespace gyromode::dense {

/// The matrices of one component, n × n, in the order of its Spectrum.
struct SecondOrder {
  const Matrix& mass;
  const Matrix& gyroscopic;
  const Matrix& stiffness;

  Index size() const { return mass.rows(); }
};

/// Those of a component with a partition: M = diag(M₁, M₂), G = [0 B; −Bᵀ 0], K = diag(K₁, K₂).
struct SecondOrderQuadrature {
  const Matrix& mass1;
  const Matrix& mass2;
  const Matrix& coupling;
  const Matrix& stiffness1;
  const Matrix& stiffness2;

  Index size() const { return mass1.rows() + mass2.rows(); }
};

/// Fills the roots, counts and path of `s`, whose order and split are set, by the solvers of theory §3. Zero roots of a
/// singular K are removed first and exactly.
void solve_second_order(const SecondOrder& m, Spectrum& s);
/// The same by those of theory §1.
void solve_second_order(const SecondOrderQuadrature& m, Spectrum& s);

/// The same with the inertia and null spaces of K₁, K₂ known.
void solve_second_order(const SecondOrderQuadrature& m, const StiffnessInertia& d1, const StiffnessInertia& d2, Spectrum& s);
/// The matrices m (n × n) by the partition that a reversing symmetry gives; shapes in the coordinates of m, s.split −1.
/// The inertia of K and its null space are those of m; false, with `s` as it was, where they are not met in the
/// coordinates of the symmetry.
bool solve_second_order(const SecondOrder& m, const ReversingSymmetry& symmetry, Spectrum& s);

/// I q̇ + G q = 0 (theory §3d): singular values of L₁⁻¹BL₂⁻ᵀ with a partition, else of the bidiagonal half of the
/// tridiagonalised L⁻¹GL⁻ᵀ. Singular values up to 8 n ε of the largest (of ‖L⁻¹GL⁻ᵀ‖_F without a partition) are zero.
void solve_first_order(const Impedance& h, Spectrum& s);

}  // namespace gyromode::dense
