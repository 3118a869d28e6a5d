#pragma once

#include "gyromode/base/types.h"

#include <vector>

namespace gyromode {

/// An impedance matrix of few coordinates with the poles of its continuous parts lifted: where a part, condensed, would
/// give −b bᴴ g(ω) with a pole in g, a coordinate is kept,
///     [ H   b  ]
///     [ bᴴ  1/g]
/// so that the matrix stays finite, Hermitian at real ω, and a motion that lives in the part alone (at its fixed-root
/// frequency) is a null vector like any other. n₋ of the whole impedance, of infinitely many coordinates, is n₋(matrix)
/// + Σ poles_below (Haynsworth; Wittrick & Williams 1971; docs/booms.md (B5), (B6)).
struct Lifted {
  ComplexMatrix matrix;
  /// a coordinate: fixed-root frequencies below ω that it stands for, less 1 where its own entry is negative; real ω
  /// only
  std::vector<Index> poles_below;
};

}  // namespace gyromode
