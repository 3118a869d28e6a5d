#pragma once

#include "gyromode/structure/coupling.h"

#include <vector>

namespace gyromode {

/// Which coordinates of an impedance meet, and how, as its parts state it from their geometry: a statement on every
/// frequency at once, which no number of samples could make. What is not stated is exactly zero, as computed, at any
/// frequency; what is stated may be anything.
class Couplings {
 public:
  explicit Couplings(Index size);

  Index size() const { return graph_.size(); }
  /// H_ik = conj H_ki may have a real part (in phase) or an imaginary one (cross), i ≠ k.
  void add(Index i, Index k, CouplingKind kind);
  /// `other` and `first` meet nothing, and have one entry and one `poles_below` at every frequency.
  void equal(Index first, Index other) { first_of_equals_[static_cast<std::size_t>(other)] = first; }

  bool meet(Index i, Index k, CouplingKind kind) const;
  /// The first of the coordinates equal to i; i itself where there is none before it.
  Index first_of_equals(Index i) const { return first_of_equals_[static_cast<std::size_t>(i)]; }
  const CouplingGraph& graph() const { return graph_; }

 private:
  CouplingGraph graph_;
  std::vector<Index> first_of_equals_;
};

}  // namespace gyromode
