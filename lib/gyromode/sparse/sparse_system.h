#pragma once

#include "gyromode/base/labels.h"
#include "gyromode/base/sparse_matrix.h"

#include <memory>
#include <optional>
#include <vector>

namespace gyromode {

namespace sparse {
struct Basis;
}

/// M, G, K of order n by what is on and below the diagonal, and which coordinates belong to one node.
struct SparseMatrices {
  SparseMatrix mass;        ///< lower triangle of M
  SparseMatrix gyroscopic;  ///< what is below the diagonal of G
  SparseMatrix stiffness;   ///< lower triangle of K
  Labels labels;            ///< n; empty: q1 … qn
  std::vector<int> node;    ///< of every coordinate, from 0; empty: each its own
  /// γ with −γM ≤ jG ≤ γM, where it is known: 2|Ω| for axes that turn at Ω. Counts may rest on it.
  std::optional<double> gyroscopic_bound = std::nullopt;
  /// Translations T, n × t, of a body that nothing holds across its axis: KT = −Ω²MT to rounding, and GT is in the span
  /// of MT. They keep to themselves, at a double root Ω that is no vibration, and are left out: what is searched and
  /// counted are motions with TᵀMq = 0.
  Matrix translations{};
  /// Motions along and about the axis of a body that nothing holds there, n × any number: they span part of null(K) by
  /// construction. Where they are all of it the zero roots are those of a rigid body.
  Matrix rigid{};
  /// Where these are not the coordinates given: those. Results are in them; labels too.
  std::shared_ptr<const sparse::Basis> basis = nullptr;
};

/// M q̈ + G q̇ + K q = 0 with M = Mᵀ > 0 (or ≥ 0 to rounding), G = −Gᵀ, K = Kᵀ, sparse. One that exists keeps these laws.
class SparseSystem {
 public:
  /// @throws LawBroken for sizes that differ, entries above the diagonal or that are not finite, a diagonal of G, and M
  /// that is indefinite beyond 10⁻¹² of its diagonal (by its factorisation)
  explicit SparseSystem(SparseMatrices matrices);

  const SparseMatrices& matrices() const { return of_; }             ///< as they were given
  Index size() const { return of_.mass.cols(); }                     ///< n
  const SparseMatrix& mass() const { return of_.mass; }              ///< lower triangle
  const SparseMatrix& gyroscopic() const { return of_.gyroscopic; }  ///< below the diagonal
  const SparseMatrix& stiffness() const { return of_.stiffness; }    ///< lower triangle
  const Labels& labels() const { return of_.labels; }                ///< n
  const std::vector<int>& node() const { return of_.node; }          ///< of every coordinate
  const Matrix& translations() const { return of_.translations; }    ///< n × t: left out of every search and count
  const Matrix& rigid() const { return of_.rigid; }                  ///< n × any number: known motions of null(K)
  const std::vector<int>& places() const { return places_; }         ///< of every node, in an order of elimination with little fill
  std::optional<double> gyroscopic_bound() const { return of_.gyroscopic_bound; }  ///< γ with −γM ≤ jG ≤ γM, where it is known
  double gyroscopic_size() const;                                 ///< about ‖M^−½GM^−½‖, by the sums of its entries
  const sparse::Basis* basis() const { return of_.basis.get(); }  ///< null: the coordinates are those given
  /// M is positive semidefinite to rounding: some motions have no mass, and no frequency of their own.
  bool singular_mass() const { return singular_mass_; }

 private:
  SparseMatrices of_;
  std::vector<int> places_;
  bool singular_mass_ = false;
};

}  // namespace gyromode
