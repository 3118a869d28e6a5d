#pragma once

#include "gyromode/appendage/appendage.h"

namespace gyromode {

/// Forces and moments against (ζ1, ζ2, ζ3, θ1, θ2, θ3): displacement of a point of axis 3 and rotation vector of the
/// body, in axes that turn with it; time factor e^{jωt}, H = K − ω²M + jωG, Hermitian. N and m, per m and rad.
using HubMatrix = Eigen::Matrix<Complex, 6, 6>;

/// T of y = T (ζ, θ), y the body coordinates of SpinOperators: ω > 0.
HubMatrix body_coordinates_of(double omega, double spin);

/// A Lifted matrix with everything but the six body coordinates eliminated (Boland & Janssens 1979, Eq. 13). Not finite
/// at a pole.
HubMatrix condensed(const Lifted& lifted);

/// What something rigid does to the body, static terms of its centrifugal force included:
///     −m N₃ on ζ + θ × p,   −mΩ²{½((Pp)pᵀ + p(Pp)ᵀ) − (Pp·p) 1} on θ,   N₃ = [p jt 0; −jt p 0; 0 0 ω²],   P = diag(1, 1, 0).
HubMatrix rigid_impedance(const MassProperties& m, double omega, double spin);

/// The whole of one appendage, frozen mass and flexibility, about the origin of its heights .
HubMatrix hub_impedance(const Appendage& appendage, double omega, double spin);

/// n₋ of the impedance of the appendage with its root held: the number of its fixed-root frequencies below ω > 0,
/// unless the spin makes some of its static stiffness negative, which is then counted from the start.
Index fixed_root_negative(const Appendage& appendage, double omega);

}  // namespace gyromode
