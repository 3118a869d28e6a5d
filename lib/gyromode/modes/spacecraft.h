#pragma once

#include "gyromode/discrete/discretise.h"
#include "gyromode/modes/count.h"
#include "gyromode/modes/modes.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/structure/transformation.h"

namespace gyromode {

/// Modes of a spacecraft with exact booms in a window, or the lowest so many: none missing where `complete`. Spin phase and axial translation (ω = 0) and the tilt of the momentum axis
/// (ω = Ω) are listed as rigid-body modes; translation across the axis is no mode of a body free in space and is not.
/// Throws std::invalid_argument for an open window without `lowest`, as there are infinitely many modes, and dense::MethodDoesNotApply for a method of matrix models.
ModesResult find_modes(const Spacecraft& spacecraft, const ModesOptions& options = {});

/// By the counts at the ends of the window alone.
CountResult count_modes(const Spacecraft& spacecraft, const Window& window, const StructureOptions& options = {});

/// Which of (ζ, θ) move in phase, which in quadrature, and which do not meet.
Structure analyse(const Spacecraft& spacecraft, const StructureOptions& options = {});

/// H(ω) on (ζ, θ) at the mass centre of the complete satellite, in N and N m per m and rad, and what makes it real symmetric.
Transformation transformation_at(const Spacecraft& spacecraft, const Structure& structure, double omega);

/// Of a mode, the angle from axis 1 to the axis of the body about which, at its frequency, rotations are in phase and rotations across it in quadrature: principal axes of the effective inertia of hub
/// and booms (Boland & Janssens 1979, Fig. 4, Eq. 19).
struct EffectiveAxes {
  double omega = 0;  ///< rad/s
  double angle = 0;  ///< ψ, rad, in (−π/4, π/4]
};
/// Of the lowest `count` modes; empty where ψ = 0 throughout, as axes 1 and 2 are such axes.
std::vector<EffectiveAxes> effective_axes(const Spacecraft& spacecraft, Index count);

/// The modes of the twin of finite elements, the tilt among them named.
ModesResult find_modes(const Spacecraft& spacecraft, const Mesh& mesh, const ModesOptions& options);

}  // namespace gyromode
