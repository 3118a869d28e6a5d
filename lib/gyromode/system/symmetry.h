#pragma once

#include "gyromode/base/types.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// Which departures from A = Aᵀ (M, K) and A = −Aᵀ (G) are let in. The (skew-)symmetric part is used then, and a Repair
/// tells what was dropped.
struct Admission {
  /// None: what is not (skew-)symmetric to the last bit is refused.
  bool strict = false;
  /// Up to this fraction of the largest |entry| of the matrix; beyond it only what is rounding, see is_rounding().
  /// 2 takes everything.
  double symmetrise = 0;
};

/// A departure d = |a_ij ∓ a_ji| counts as rounding where
///     d ≤ 1e-12 max |a|   or   d ≤ 1e-8 √(r_i r_j),   r_i the largest |entry| of row and column i:
/// what reductions TᵀKT in double precision and files of nine digits leave.
bool is_rounding(double departure, double largest, double row_i, double row_j);

/// A matrix that was not (skew-)symmetric: its (skew-)symmetric part is used.
struct Repair {
  std::string matrix;    ///< M, G, K; I
  Index row = 0;         ///< where the departure is largest, from 0, row ≥ column
  Index column = 0;      ///< its mirror image is (column, row)
  double size = 0;       ///< |a_ij ∓ a_ji| there, in the unit of the matrix
  double departure = 0;  ///< the same over the largest |entry|
  double own_scale = 0;  ///< the largest |a_ij ∓ a_ji| / √(r_i r_j)
  bool asked = false;    ///< more than rounding: let in because Admission::symmetrise says so
  /// ½(A ∓ Aᵀ), n × n: what was taken out
  std::shared_ptr<const Matrix> dropped;
  /// What the dropped part does to the modes and growing motions listed, rad per unit of time: the largest |δλ|, of
  /// leading order, over roots λ = σ + jω. The skew part of K or M and the symmetric part of G shift no simple mode in
  /// first order and let it grow or decay (theory (T16)). Nothing where no modes were computed.
  std::optional<double> largest_effect;
  double effect_at = 0;    ///< ω of the mode it acts on most
  double error_bound = 0;  ///< of that mode

  /// "K departs from symmetry by 1.1e-13 of its largest entry at (3,2)", entries from 1; and what that does, where it
  /// is known.
  std::string in_words() const;
  /// Whether what was dropped may be no rounding at all: small beside the largest entry alone, as the coupling of soft
  /// coordinates is beside a stiff one, and more to a root than its error bound, or nobody knows what. No verdict can
  /// stand on that.
  bool doubtful() const;
};

/// Makes `a` exactly symmetric (sign 1) or skew (−1). @returns what was repaired, nothing where it is exactly so.
/// @throws LawBroken for a departure that is not let in
std::optional<Repair> made_symmetric(std::string_view name, Matrix& a, int sign, const Admission& admission);

/// ½(A + Aᵀ) and ½(A − Aᵀ).
/// Whether a matrix is (skew-)symmetric but for what is let in as rounding.
bool departs_by_rounding(const Matrix& a, int sign);

Matrix symmetric_part(const Matrix& a);
Matrix skew_part(const Matrix& a);

}  // namespace gyromode
