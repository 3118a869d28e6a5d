#pragma once

#include "gyromode/sparse/shape_block.h"

namespace gyromode::sparse {

/// How the states of an operator stand for motions Re(X e^{jωt}).
struct StateKind {
  bool pairs = false;  ///< (q, q̇), two of them a motion: their complex sum; else (displacements of one group, velocities of the other)
  Index leads = 0;     ///< the group whose displacements they are
};

/// The shapes of states: (x, ẏ) is X = (x, −jẏ/ω), times j where x is in quadrature; (q, q̇) of a pair is X = q + j q'.
ShapeBlock motions_of(const Groups& groups, StateKind kind, const Vector& omega, const Matrix& states, const Matrix& other_states);

/// The states of shapes: the first of a pair, and the second.
struct StatesOfMotions {
  Matrix first, second;
};
StatesOfMotions states_of(const Groups& groups, StateKind kind, const ShapeBlock& shapes);

}  // namespace gyromode::sparse
