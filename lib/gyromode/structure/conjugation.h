#pragma once

#include "gyromode/base/types.h"

#include <random>
#include <vector>

namespace gyromode {

/// Consecutive positions that belong together: eigenvalues nearer to each other than what rounding moves them.
struct Cluster {
  Index first = 0, count = 0;
};
/// Neighbours of an ascending vector at most `width` apart.
std::vector<Cluster> clusters_of(const Vector& ascending, double width);

/// Given a unitary U (n × n) and W = UᵀU, seeks D complex symmetric, block-diagonal over `clusters`, that makes X = Ū D
/// Uᴴ real:
///     X = X̄  ⇔  D = W D̄ W.
/// D ↦ P(W D̄ W), P the restriction to the blocks, is real-linear and symmetric with eigenvalues ±σ, 0 ≤ σ ≤ 1; what is
/// sought has eigenvalue 1.
class Conjugation {
 public:
  Conjugation(ComplexMatrix u, std::vector<Cluster> clusters);

  /// One solution by the strongest couplings, as the real part of X (n × n, symmetric): a D of phases satisfies d_i d_j
  /// = w_ij/w̄_ij, so a maximum spanning tree over |w_ij| gives all of a connected set from one of them, and its
  /// strongest odd cycle or w_ii that one. `noise`: of the eigenvectors, one number each (phases_by_couplings). Blocks
  /// of clusters follow from the rest. Cheap; to be verified, as nothing is decided here.
  Matrix by_strongest_couplings(const Vector& noise) const;

  /// Computes the space of solutions, for what follows: robust for clusters and several solutions, and at least as
  /// expensive as the eigenproblem of U.
  void decompose();
  /// A generic element of the span of solutions D of unit length with ‖Im X‖_F within about `spread` of the least, as
  /// the real part of X.
  Matrix real_element(double spread, std::uint64_t seed) const;
  /// The largest eigenvalue: 1 where a real X exists.
  double largest() const { return values_.size() == 0 ? 0 : values_.maxCoeff(); }
  Index unknowns() const { return size(); }

 private:
  struct Unknown {
    Index i, j;  // i ≤ j: (e_i e_jᵀ + e_j e_iᵀ)/√2, e_i e_iᵀ
  };
  Index size() const { return static_cast<Index>(unknowns_.size()); }
  Vector applied(const Vector& d) const;  // on (Re d, Im d)
  void make_blocks_unitary(Vector& d) const;
  Matrix real_part(const Vector& d) const;
  Matrix operator_matrix() const;
  void decompose_densely();
  void decompose_by_lanczos();
  ComplexMatrix times_blocks(const ComplexMatrix& a, const Vector& d) const;  // A D
  void sharpen();
  Matrix imaginary_part(const Matrix& s, const Matrix& z) const;

  ComplexMatrix u_;
  std::vector<Cluster> clusters_;
  ComplexMatrix w_;
  std::vector<Unknown> unknowns_;
  Vector values_;      // eigenvalues (Ritz values)
  Matrix vectors_;     // of D, 2·size() rows; in the end those beside the largest eigenvalue
  Vector departures_;  // ‖Im X‖_F of each of these
};

}  // namespace gyromode
