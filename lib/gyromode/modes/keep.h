#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/spectrum/inertia.h"

namespace gyromode {

/// The impedance condensed onto chosen coordinates b, the others i eliminated (Boland & Janssens 1979, Eqs. 13–15):
///     H_red(ω) = H_bb − H_bi H_ii⁻¹ H_ib,   J(ω) = n₋(H_ii) + n₋(H_red) = n₋(H)   (Haynsworth).
struct ReducedImpedance {
  ComplexMatrix reduced;   ///< H_red, Hermitian; H_bb where H_ii is singular to rounding
  Inertia internal, kept;  ///< of H_ii and H_red; doubtful at a pole or a mode to rounding
};
ReducedImpedance reduced_impedance(const System& system, const std::vector<Index>& kept, double omega);

/// The modes of a system seen from some of its coordinates: those in which none of the `kept` takes part are `local`.
/// These are all modes of a component without kept coordinates; and in any other, at each ω, dim null H_ii(ω) −
/// rank(H_bi(ω) on that null space) modes (modes/local_modes.h). What rounding leaves undecided is no local mode.
ModesResult find_modes_keeping(const System& system, const std::vector<Index>& kept, const ModesOptions& options);

}  // namespace gyromode
