#pragma once

#include "gyromode/sparse/folding.h"
#include "gyromode/structure/structure.h"

#include <optional>
#include <string>

namespace gyromode::sparse {

/// The coordinates that a system is given in, q = Q p, where it is written in others, p, QᵀQ = 1.
struct Basis {
  std::optional<SparseMatrix> turn;           ///< of the directions of every node; none: they are those given
  Involution fold;                            ///< q = turn · F p
  Structure given;                            ///< what the couplings of q show
  double departure = 0;                       ///< of the symmetry, relative: what was averaged away
  double norm_m = 0, norm_g = 0, norm_k = 0;  ///< 1-norms in q
  std::string in_words;                       ///< of the symmetry
};

/// q = Q p; the same where the system is written in the coordinates given.
ComplexVector in_given(const SparseSystem& system, const ComplexVector& p);
/// p = Qᵀq of columns.
Matrix from_given(const SparseSystem& system, const Matrix& q);

}  // namespace gyromode::sparse
