#pragma once

#include "gyromode/certificate/measure.h"

namespace gyromode {

/// Moves every ω of `s` to the root of Xᴴ H(ω) X = 0 near it (the Rayleigh functional, whose error is quadratic in that
/// of X) by Newton's method, where that is a correction and no jump; likewise every unstable λ by correct_unstable().
/// `s` is in ascending order then, and measured.
Assessment correct(const Impedance& h, Spectrum& s);

/// Moves every λ to the root of YᴴN(λ)X = 0 near it, N(λ) = K + λG + λ²M: two steps of Newton's method at most, each a
/// small part of |λ| that makes the residual smaller. A real λ stays real. Measured then.
Assessment::Unstable correct_unstable(const Impedance& h, Spectrum& s);

/// Brings the roots of `s` into ascending order.
void sort_by_frequency(Spectrum& s);

}  // namespace gyromode
