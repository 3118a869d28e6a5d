#pragma once

#include "gyromode/lapack/types.h"

#include <random>
#include <vector>

namespace gyromode {

/// Consecutive positions that belong together: eigenvalues nearer to each other than what rounding moves them.
struct Cluster {
  Index first = 0, count = 0;
};
/// Neighbours of an ascending vector at most `width` apart.
std::vector<Cluster> clusters_of(const Vector& ascending, double width);

/// Given a unitary U (n × n) and W = UᵀU, seeks D complex symmetric, block-diagonal over `clusters`, that makes X = Ū D Uᴴ real:
///     X = X̄  ⇔  D = W D̄ W.
/// D ↦ P(W D̄ W), P the restriction to the blocks, is real-linear and symmetric with eigenvalues ±σ, 0 ≤ σ ≤ 1; what is sought has eigenvalue 1.
class Conjugation {
 public:
  Conjugation(ComplexMatrix u, std::vector<Cluster> clusters);

  /// A generic element of the span of solutions D of unit length with ‖Im X‖_F within about `spread` of the least, as the real part of X (n × n, symmetric).
  Matrix real_element(double spread, std::uint64_t seed) const;
  /// The largest eigenvalue: 1 where a real X exists.
  double largest() const { return values_.size() == 0 ? 0 : values_.maxCoeff(); }

 private:
  struct Unknown {
    Index i, j;  // i ≤ j: (e_i e_jᵀ + e_j e_iᵀ)/√2, e_i e_iᵀ
  };
  Index size() const { return static_cast<Index>(unknowns_.size()); }
  Vector applied(const Vector& d) const;  // on (Re d, Im d)
  Matrix operator_matrix() const;
  void decompose_densely();
  void decompose_by_lanczos();
  ComplexMatrix element(const Vector& d) const;  // X = Ū D Uᴴ
  void sharpen();

  ComplexMatrix u_;
  std::vector<Cluster> clusters_;
  ComplexMatrix w_;
  std::vector<Unknown> unknowns_;
  Vector values_;      // eigenvalues (Ritz values)
  Matrix vectors_;     // of D, 2·size() rows; in the end those beside the largest eigenvalue
  Vector departures_;  // ‖Im X‖_F of each of these
};

}  // namespace gyromode
