#pragma once

#include "gyromode/impedance/converge.h"

namespace gyromode {

/// Roots of one block at which its count J falls: modes of negative energy. J is taken at samples of ω over all decades; an interval of them over which it falls is bisected to single falls.
/// Verified one by one; none is missed but by a root of positive energy in the same interval of samples, which takes the fall back.
std::vector<Root> falls(const BlockedImpedance& h, Index block);

}  // namespace gyromode
