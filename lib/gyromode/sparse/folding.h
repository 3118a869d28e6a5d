#pragma once

#include "gyromode/sparse/sparse_system.h"

#include <string>
#include <vector>

namespace gyromode::sparse {

/// An involution S of the coordinates: (Sq)_i = sign_i q_partner(i), partner(partner(i)) = i.
struct Involution {
  std::vector<Index> partner;
  std::vector<signed char> sign;  ///< 1 or −1; the same for both of a pair
};

/// By how much S fails to keep M and K and to reverse G: SᵀMS = M, SᵀKS = K, SᵀGS = −G.
struct Departure {
  double largest = 0;  ///< of an entry over the root of its two diagonal entries; of G, over its largest
  char matrix = 'M';   ///< where that is
  Index row = 0, column = 0;
};
Departure departure_of(const SparseMatrices& matrices, const Involution& s);

/// The matrices in p, q = F p, FᵀF = 1, with the parts that S does not keep left out:
///     q_i = (p_i + p_i')/√2,  q_i' = sign_i (p_i − p_i')/√2   of a pair i < i' = partner(i),   q_i = p_i of the others.
/// p_i of a pair, and the others of sign 1, are even under S, the rest odd: M and K couple neither with the other, G
/// nothing else. Both of a pair belong to the node of i. The result has no labels.
SparseMatrices folded(const SparseMatrices& matrices, const Involution& s);

/// p = Fᵀq of columns q.
Matrix folded(const Involution& s, const Matrix& q);
/// q = F p.
ComplexVector unfolded(const Involution& s, const ComplexVector& p);

}  // namespace gyromode::sparse
