#pragma once

#include "gyromode/elements/discretise.h"

namespace gyromode {

/// A point of a boom or a sprung mass.
struct BoomPoint {
  enum class Part { cable, beam, mass };
  Part part = Part::cable;
  Index number = 1;    ///< from 1, in the order of the model
  double along = 1;    ///< from root, 0, to tip, 1; of no meaning for a mass

  std::string name() const;  ///< "cable1@0.5", "mass2"
};

/// Throws InvalidArgument where the spacecraft has no such part, or `along` is outside [0, 1].
void require_point(const Spacecraft& s, const BoomPoint& point);
/// Its steady place from the centre of mass P of the complete satellite, m.
Eigen::Vector3d steady_place(const Spacecraft& s, const BoomPoint& point);
/// Its displacement relative to the body as a linear map of the twin's coordinates, 3 × n.
Matrix relative_displacement(const Spacecraft& s, const Mesh& mesh, const System& twin, const BoomPoint& point);

}  // namespace gyromode
