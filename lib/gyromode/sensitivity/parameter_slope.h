#pragma once

#include "gyromode/base/types.h"

#include <functional>
#include <optional>
#include <vector>

namespace gyromode {

/// A matrix function of one parameter: its derivative, and what is open of it.
struct MatrixSlope {
  Matrix value;  ///< ∂A/∂p
  Matrix error;  ///< entry by entry: of the truncation, by a stencil of lower order, and of rounding
};

/// M, G and K of a model with the parameter at a value; may throw LawBroken, or return matrices of another order.
struct ParameterMatrices {
  std::vector<Matrix> all;
};
using MatricesAt = std::function<ParameterMatrices(double value)>;

/// Derivatives of all of them at a value by central differences of eighth order, over ±4 steps of a fiftieth of the
/// value; of a value of 0 the step is what changes an entry by 10⁻⁴ of the largest. Shorter steps are taken where the
/// model is lawful only for them, or where they leave less open. Nothing where it never is, or where the order of the
/// matrices changes with the parameter.
std::optional<std::vector<MatrixSlope>> parameter_slopes(const MatricesAt& at, double value);

/// Roots of one frequency: their change with a parameter, to first order.
struct RootSlopes {
  Vector value;  ///< ascending
  Vector error;
};

/// Of shapes X, n × m, of one root ω: the eigenvalues of the pencil (XᴴDX, XᴴFX), D = ∂H/∂p at fixed ω and F = −∂H/∂ω
/// (theory (T15)). `d` and `f` are applied to X; `error` is |D − what was computed|, entry by entry; empty: rounding of
/// the products. Nothing where XᴴFX is of both signs.
std::optional<RootSlopes> root_slopes(const ComplexMatrix& x, const ComplexMatrix& dx, const ComplexMatrix& fx, const Matrix& error);

}  // namespace gyromode
