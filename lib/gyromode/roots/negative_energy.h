#pragma once

#include "gyromode/roots/converge.h"

namespace gyromode {

/// Roots of one block at which its count J falls: modes of negative energy. Of samples of ω, ascending, an interval
/// over which J falls is bisected to single falls, each verified; none is missed but by a root of positive energy in
/// the same interval, which takes the fall back; of such pairs those are found between which an eigenvalue has its
/// extremum.
std::vector<Root> falls(const BlockedImpedance& h, Index block, const std::vector<double>& samples);

/// Over all decades that the spin may feed; and around a frequency near which one may be.
std::vector<double> samples_of_all_decades();
std::vector<double> samples_around(double omega);

}  // namespace gyromode
