#pragma once

#include "gyromode/spectrum/unstable_roots.h"
#include "gyromode/base/types.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gyromode::dense {

/// The coordinates in which shapes of one group are asked for: each function replaces its columns by theirs. Without
/// functions they are those of the form.
struct ShapeCoordinates {
  std::function<void(MatrixSpan)> from_normal;  ///< from x of the form
  /// from s = fᵀx of a square root f; one triangular solve where f and the mass factor would take one each
  std::function<void(MatrixSpan)> from_root;
};

/// One diagonal block k (n × n) of a mass-normalised stiffness; where k ≥ 0 also a root f with k = f fᵀ, n × q, q < n
/// only where the null space is gyroscopically coupled (see Deflation). Each costs a congruence, and not every solver
/// asks for both: they may be given as recipes.
class StiffnessBlock {
 public:
  using Recipe = std::function<Matrix()>;
  explicit StiffnessBlock(Matrix k) : k_(std::move(k)), null_(k_->rows(), 0) {}
  StiffnessBlock(Matrix k, Matrix root) : k_(std::move(k)), root_(std::move(root)), null_(k_->rows(), 0) {}
  /// `root` is empty where k is indefinite. Called at most once.
  StiffnessBlock(Index size, Recipe k, Recipe root) : k_recipe_(std::move(k)), root_recipe_(std::move(root)), null_(size, 0) {}

  Index size() const { return null_.rows(); }
  bool has_root() const { return root_ || root_recipe_; }
  const Matrix& k() const { return made(k_, k_recipe_); }
  const Matrix& root() const { return made(root_, root_recipe_); }

  /// Gyroscopically coupled null vectors of k, n × s, orthonormal; s = 0 for a regular K.
  const Matrix& null() const { return null_; }
  void set_null(Matrix null) { null_ = std::move(null); }

  /// x := the shapes asked for, of x in the coordinates of the form.
  void shapes(MatrixSpan x) const {
    if (asked_.from_normal) asked_.from_normal(x);
  }
  /// The same of s = fᵀx, f square and lower triangular.
  void shapes_of_root(MatrixSpan s) const;
  void ask_for(ShapeCoordinates coordinates) { asked_ = std::move(coordinates); }

 private:
  static const Matrix& made(std::optional<Matrix>& matrix, const Recipe& recipe) {
    if (!matrix) matrix = recipe();
    return *matrix;
  }

  mutable std::optional<Matrix> k_, root_;
  Recipe k_recipe_, root_recipe_;
  Matrix null_;
  ShapeCoordinates asked_;
};

/// The quadrature class in mass-normalised coordinates (theory (T4)):
///     ẍ + b ẏ + k₁ x = 0,   ÿ − bᵀ ẋ + k₂ y = 0,    b p × r.
struct QuadratureForm {
  Matrix b;
  StiffnessBlock first, second;
};

/// Motions X = (x, −j y) e^{jωt} with real x (p × m) and y (r × m), ω > 0 ascending; and the roots off the imaginary
/// axis. All in the coordinates that the blocks ask for.
struct QuadratureModes {
  Vector omega;
  Matrix x, y;
  UnstableRoots unstable;  ///< X = (x, y) of X e^{λt}; Y = (x̄, −ȳ), as T reverses time
  std::string solver;
};

/// Y of a root with X = (x, y), x the first `in_phase` rows: with T = diag(1, −1) reversing time, TN(λ)T = N(−λ), so
/// that Y = T X̄ belongs to −λ̄.
ComplexVector reversed(const ComplexVector& right, Index in_phase);

/// All roots of the form, by what its blocks allow:
///   a block ≥ 0      W of (T5), real symmetric n × n; the singular values of C, W = CCᵀ, where small frequencies ask for it;
///   both indefinite  P of (T6), real n × n, its close roots separated by the self-adjoint form that P has.
/// Frequencies are relative to the unit of time of the form: scale it so that ‖k‖ is near 1.
QuadratureModes quadrature_modes(const QuadratureForm& form);

}  // namespace gyromode::dense
