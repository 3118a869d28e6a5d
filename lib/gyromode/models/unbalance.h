#pragma once

#include "gyromode/models/model_kind.h"
#include "gyromode/rotor/rotor.h"

namespace gyromode {

/// Masses at places that are named by the label of x. @throws InvalidArgument where there is none of the name
ModelKind::TurningForce unbalance_at(const std::vector<OrbitCoordinates>& places, const Labels& labels,
                                     const std::vector<Unbalance>& masses);
/// Masses on a rotor: "disk2", "disc2", "point_mass1", "bearing1", "station4" ("inner.station4" of a spool), counted
/// from 1. @throws InvalidArgument for a place that it has not, a mass where something is held, or masses on shafts of
/// different speed
ModelKind::TurningForce unbalance_on(const Rotor& rotor, const std::vector<Unbalance>& masses);

}  // namespace gyromode
