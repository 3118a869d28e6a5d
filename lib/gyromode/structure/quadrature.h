#pragma once

#include "gyromode/structure/coupling.h"

#include <memory>
#include <optional>
#include <vector>

namespace gyromode {

/// Connected components and, for each, the quadrature partition of Boland & Janssens 1979, Eq. (8) or the witness that
/// there is none: a 2-colouring with parity in which in-phase couplings keep the colour and cross couplings change it
/// (theory (T3)). Every stored coupling is visited once a direction.
std::vector<Component> partition(const CouplingGraph& graph);

}  // namespace gyromode
