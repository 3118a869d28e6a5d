#pragma once

#include "gyromode/spectrum/result.h"
#include "gyromode/sweep/whirl.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace gyromode {

/// What two branches do where they come near.
enum class EncounterKind {
  crossing,   ///< they pass through each other: a symmetry separates them
  veering,    ///< they turn away from each other and exchange their shapes
  collision,  ///< roots of opposite energy sign meet and leave the axis: flutter
  ambiguous   ///< which of these cannot be told: the gap is within the error of the frequencies
};
std::string_view to_string(EncounterKind kind);

/// Two branches that come near to each other.
struct Encounter {
  EncounterKind kind = EncounterKind::crossing;  ///< what they do
  double spin = 0;                               ///< of the crossing, the smallest gap, or the collision
  double omega = 0;                              ///< there, the mean of both
  std::array<Index, 2> branches{};               ///< the lower one below the spin first
  double gap = 0;                                ///< smallest distance of the frequencies: 0 of crossings and collisions
  double error = 0;                              ///< on the gap
  std::optional<std::array<double, 2>> flutter;  ///< spins between which the roots are off the axis, of a collision
};

/// Where a branch meets the line ω = m|Ω| of an excitation of order m, in the axes of the model.
struct Intersection {
  double order = 1;            ///< m
  double spin = 0;             ///< Ω, rad per unit of time
  Index branch = 0;            ///< of the track
  double omega = 0;            ///< m|Ω|
  double error = 0;            ///< on |δΩ|, to first order
  std::optional<Whirl> whirl;  ///< there, where the model has places
};

/// The intersections of one order, ascending in the spin, and how far they are known to be all.
struct Intersections {
  double order = 1;               ///< m
  std::vector<Intersection> all;  ///< ascending in the spin
  Coverage coverage;              ///< of the spins Ω > 0 of the range; not_counted where only the signs of ω − mΩ at the spins say
};

}  // namespace gyromode
