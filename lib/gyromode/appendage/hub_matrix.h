#pragma once

#include "gyromode/lapack/types.h"

namespace gyromode {

/// Impedance at the hub: forces and moments against (ζ1, ζ2, ζ3, θ1, θ2, θ3), displacement of a point O of axis 3 and rotation vector of the body, in axes that turn with it.
/// Time factor e^{jωt}, H = K − ω²M + jωG, Hermitian.
using HubMatrix = Eigen::Matrix<Complex, 6, 6>;

}  // namespace gyromode
