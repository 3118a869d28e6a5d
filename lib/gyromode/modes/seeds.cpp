#include "gyromode/modes/seeds.h"

#include "gyromode/base/error.h"
#include "gyromode/elements/discretise.h"
#include "gyromode/elements/spin_phase.h"
#include "gyromode/modes/modes.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Modes of opposite energy that the twin has near each other may be fluttering, and the reverse: both ways are looked.
void add_pairs(const ModesResult& twin, double unit, Seeds& seeds) {
  constexpr double near = 0.05;
  for (const Mode& negative : twin.negative_modes) {
    for (const Mode& m : twin.modes) {
      const double gap = std::abs(m.omega - negative.omega);
      if (m.energy_sign > 0 && gap > 0 && gap <= near * negative.omega)
        seeds.growing.push_back(Complex(0.5 * gap, 0.5 * (m.omega + negative.omega)) / unit);
    }
  }
  for (const UnstableMode& u : twin.unstable) {
    if (u.flutter() && u.growth_rate <= near * u.omega) seeds.negative_energy.push_back(u.omega / unit);
  }
}

}  // namespace

std::optional<Seeds> seeds_of(const Spacecraft& s, Index attempt) {
  const Index booms = std::max<Index>(1, static_cast<Index>(s.cables().size() + s.beams().size()));
  const Index degrees[] = {4, std::clamp<Index>(200 / booms, 5, 16)};
  if (attempt >= static_cast<Index>(std::size(degrees))) return std::nullopt;
  constexpr double highest = 30;  // spins: growth and negative energy are slow motions
  Seeds seeds;
  try {
    const WithoutSpinPhase whole(discretise(s, {1, degrees[attempt]}), spin_phase_of_twin);
    const ModesResult twin = find_modes(low_modes(whole.system(), highest * s.spin()));
    for (const Mode& m : twin.negative_modes) seeds.negative_energy.push_back(m.omega / s.spin());
    for (const UnstableMode& u : twin.unstable) seeds.growing.push_back(Complex(u.growth_rate, u.omega) / s.spin());
    add_pairs(twin, s.spin(), seeds);
  } catch (const NotConverged&) {  // then there are none, and the balance says that something is missing
  }
  return seeds;
}

}  // namespace gyromode
