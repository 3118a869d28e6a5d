#pragma once

#include "gyromode/sparse/inverse.h"

#include <vector>

namespace gyromode::sparse {

/// Block Lanczos with full orthogonalisation in E and thick restart:  Op U = U H + U₊ R Eᵀ,  ⟨U, U⟩ = 1,  with E the
/// last columns. H = ⟨U, Op U⟩ is kept whole, so that a restart U ← U Y and a block from elsewhere change nothing in
/// the recurrence.
class Lanczos {
 public:
  /// Blocks of `width` from random shapes of order n; at most `most` columns are kept.
  Lanczos(const Inverse& inverse, Index n, Index width, Index most);

  /// One block more, after a restart where there is no room. @returns false where nothing new comes
  bool step();
  /// Goes on from `width` random shapes of their own: more roots of one frequency than a block has columns are not seen
  /// otherwise.
  void refresh(Index width);

  /// Eigenvalues of H, the outermost first.
  struct Ritz {
    Vector theta;     ///< of a skew-adjoint operator |θ|, one for each pair
    Vector residual;  ///< ‖Op u − θu‖ in E, ‖u‖ = 1
    Matrix re, im;    ///< coefficients in U, p × m; im is empty where they are real
  };
  Ritz ritz() const;
  /// Combinations of U.
  Matrix combined(const Matrix& coefficients) const;
  /// Op applied once more to states, one of each Ritz vector `which` (of a pair one of the two): what is farther from
  /// the shift than these gets smaller. What is nearer would get larger: the parts of all other Ritz vectors, which Op
  /// u = θu + … has by rounding alone, are taken away.
  Matrix refined(const Matrix& states, const Ritz& ritz, const std::vector<Index>& which) const;

  Index size() const { return size_; }
  Index applied() const { return applied_; }  ///< columns that the operator was applied to

 private:
  static constexpr Index most_carried = 14;  // blocks

  void append(const States& block);
  bool carried() const { return rough_ && blocks_ <= most_carried; }
  void restart();
  States orthonormalised(States w, Matrix& onto, Matrix& rest) const;

  const Inverse& inverse_;
  bool rough_;
  Index n_, width_, most_;
  Index size_ = 0, last_ = 0, applied_ = 0;
  unsigned draws_ = 0;
  Matrix u_, h_;
  Matrix eu_;  // E U of the first blocks
  Index blocks_ = 0;
  States next_;
  Matrix rest_;  // R
};

/// Shapes of random entries in [−1, 1], the same on every machine.
Matrix random_shapes(Index n, Index width, unsigned draw);

}  // namespace gyromode::sparse
