#pragma once

#include "gyromode/structure/structure.h"

#include <optional>

namespace gyromode {

/// How a Hermitian matrix was made real symmetric.
enum class Realification {
  partition,    ///< U = T = diag(1, −j): one for every ω (Boland & Janssens 1979, Eqs. 10–12)
  angle,        ///< U = S(ψ), 2 × 2 (Eqs. 16–20)
  tridiagonal,  ///< Householder reflections and phases, any n (theory §3b)
};
std::string_view to_string(Realification how);

/// A Hermitian matrix H and a unitary U with H* = UᴴHU real symmetric (Eq. 12); H* has no imaginary part at all, and
/// ‖UᴴHU − H*‖ and ‖UᴴU − 1‖ are rounding.
struct Realified {
  ComplexMatrix impedance;                         ///< H, n × n
  ComplexMatrix unitary;                           ///< U, n × n
  Matrix real_symmetric;                           ///< H*, n × n
  Realification how = Realification::tridiagonal;  ///< by what U was found
  std::optional<double> angle;                     ///< ψ, rad, of S(ψ)

  /// Of H* and so of H, counted on H equilibrated: in any units of the coordinates.
  Index negative() const;        ///< n₋; eigenvalues of the equilibrated matrix within 8 n ε of zero, relative to the largest, are none
  int determinant_sign() const;  ///< −1, 0 (singular to rounding) or 1

  Vector equilibrated_eigenvalues() const;  ///< of D H D, D powers of two (D H* D with a partition)
};

/// The constant T of a partition: `in_quadrature` are the coordinates that take −j. H must be real within the groups
/// and imaginary across; what contradicts is dropped, and ‖UᴴHU − H*‖ tells its size.
Realified realify_by_partition(const ComplexMatrix& h, const std::vector<Index>& in_quadrature);

/// S(ψ) of a 2 × 2 matrix H = [a, c + jb; c − jb, d]:
///     S = [cos ψ, j sin ψ; sin ψ, −j cos ψ],   tan 2ψ = 2c/(a − d)                   (Eqs. 17, 19)
///     H* = [a cos²ψ + d sin²ψ + c sin 2ψ, b; b, a sin²ψ + d cos²ψ − c sin 2ψ]        (Eq. 18, in which the print has c/2 for c).
/// ψ = ½ atan2(2c, a − d), defined at a = d and c = 0, plus the multiple of 90° that brings it nearest to `near`; where
/// c and a − d vanish to rounding every angle serves and it is `near` itself. So ψ is continuous along ω when it is
/// handed from one frequency to the next. Throws InvalidArgument where h is not 2 × 2.
Realified realify_by_angle(const ComplexMatrix& h, double near = 0);

/// Householder tridiagonalisation with a diagonal of phases, for any Hermitian n × n: H* is tridiagonal with
/// subdiagonal ≥ 0.
Realified realify_by_reflections(const ComplexMatrix& h);

/// The one of the three that fits: the partition where the structure has one, else S(ψ) for n = 2, else reflections.
Realified realify(const ComplexMatrix& h, const Structure& structure, double near = 0);

}  // namespace gyromode
