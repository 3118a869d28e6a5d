#pragma once

#include "gyromode/structure/structure.h"

namespace gyromode {

/// The impedance matrix at one frequency and a unitary U that makes it real symmetric: H* = UᴴHU (Boland & Janssens 1979, Eq. 12).
struct Transformation {
  double omega = 0;
  ComplexMatrix impedance;  ///< H, n × n
  ComplexMatrix unitary;    ///< U, n × n
  Matrix real_symmetric;    ///< H*, n × n
};

/// Quadrature class: U = T, 1 on the coordinates in phase and −j on those in quadrature (Eq. 10), the same for every ω, in the order of the
/// coordinates. General class: U from the Householder tridiagonalisation of H(ω), H* tridiagonal, different for every ω (theory §3b).
Transformation transformation_at(const System& system, const Structure& structure, double omega);
Transformation transformation_at(const FirstOrderSystem& system, const Structure& structure, double omega);

/// The same for any Hermitian H, n × n, of which the structure is known.
Transformation transformation_of(const ComplexMatrix& impedance, const Structure& structure, double omega);

}  // namespace gyromode
