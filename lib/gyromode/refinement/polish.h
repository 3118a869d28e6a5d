#pragma once

#include "gyromode/certificate/measure.h"
#include "gyromode/dense/impedance.h"

namespace gyromode {

/// Refines the roots whose residual is above 4 n ε, groups of overlapping error intervals together, and measures them
/// again. Each costs a factorisation or two of H; at most `most` groups are refined, lowest frequencies first (what is
/// left keeps its honest residual). Beyond order 64 only those above 24 n ε, 4·10⁶/n² of them.
void polish(const dense::Impedance& h, Spectrum& s, Assessment& a, Index most = 400);

}  // namespace gyromode
