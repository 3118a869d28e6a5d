#pragma once

#include "gyromode/structure/structure.h"
#include "gyromode/system/spin_family.h"

namespace gyromode {

/// Components and partition that a family has at every spin: those at a spin where no entries of G₀ and ΩG₁, or of K₀
/// and Ω²K₂, cancel.
Structure structure_of(const SpinFamily& family);

}  // namespace gyromode
