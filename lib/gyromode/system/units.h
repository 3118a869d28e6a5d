#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// Units in which a system is of its own size: q_i = coordinate_i · q̂_i, t = time · t̂. All are powers of two, so that
/// changing to them and back adds no rounding, and a system given in other units (by powers of two) is the same system
/// to the last bit in these.
struct Units {
  Vector coordinate;
  double time = 1;

  static Units given(Index n) { return {Vector::Ones(n), 1}; }
};

/// The units in which the diagonal of M̂ (I in first order) lies in [½, 2) and the largest entry of Ĝ, or the square
/// root of that of K̂, is near 1: from the diagonal of M (n), and K and G as one matrix each (k1, g: n × n; k2 0 × 0)
/// or, with `blocks`, as K = diag(k1, k2) and the upper right block g of G.
Units natural_units(const Vector& mass_diagonal, const Matrix& k1, const Matrix& k2, const Matrix& g, bool blocks);

/// a_ik := a_ik · rows_i · columns_k · factor, all of them powers of two (`factor`: time² for a stiffness, time for G).
/// No product in between overflows where the result does not.
void change_units_of(Matrix& a, const Vector& rows, const Vector& columns, double factor);

}  // namespace gyromode
