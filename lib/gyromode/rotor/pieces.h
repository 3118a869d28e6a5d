#pragma once

#include "gyromode/rotor/rotor.h"
#include "gyromode/rotor/shaft_element.h"

#include <functional>

namespace gyromode {

/// A piece of shaft between two neighbouring stations.
struct PieceBetween {
  const Station& lower;         ///< end
  const Station& upper;         ///< end
  const ShaftSection& section;  ///< that it is of
  double speed_ratio;           ///< of its spool
  ShaftPiece piece;             ///< its length, cross-sections and material
};

/// Every piece of every shaft.
void each_piece(const Rotor& rotor, const std::function<void(const PieceBetween&)>& see);

}  // namespace gyromode
