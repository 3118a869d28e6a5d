#pragma once

#include "gyromode/base/types.h"

namespace gyromode {

/// Patterns in which equal appendages move together, from how each feels the body: row i of `features` (n × f) is what
/// appendage i makes of f motions of the body. Only the first `coupled` patterns feel the body at all; in the others,
/// orthogonal to every motion of it, the appendages move as if it were held.
struct Patterns {
  Matrix vectors;   ///< n × n orthogonal, one pattern a column
  Matrix response;  ///< coupled × f: vectorsᵀ features; entries that are rounding are exactly zero
  Matrix gram;      ///< f × f: featuresᵀ features, likewise
  Index coupled = 0;
};

/// Motions that no appendage couples have patterns apart, so that symmetric sets fall into blocks.
Patterns patterns(const Matrix& features);

}  // namespace gyromode
