#pragma once

#include "gyromode/motion/state.h"
#include "gyromode/system/system.h"

namespace gyromode::reference {

/// (q, q̇) at time t of M q̈ + G q̇ + K q = f cos νt, to 50 digits and rounded: the exponential of the first-order matrix,
/// with a pair of coordinates more for the force, in ball arithmetic (Arb). The matrices are taken as exact.
State exact_state(const System& system, const State& initial, double t);
State exact_state(const System& system, const State& initial, const Vector& force, double nu, double t);

}  // namespace gyromode::reference
