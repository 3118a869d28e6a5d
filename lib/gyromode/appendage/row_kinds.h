#pragma once

#include "gyromode/appendage/spin_operators.h"
#include "gyromode/roots/couplings.h"

#include <array>

namespace gyromode {

/// What the entries of a row over the six body coordinates are at real ω: zero at every frequency, real, imaginary, or
/// of both parts.
enum class EntryKind { none, real, imaginary, complex };
using RowKinds = std::array<EntryKind, body_coordinates>;

/// Row `own` of a Lifted matrix, over the body, is of these kinds.
inline void add_row(Couplings& to, Index own, const RowKinds& row) {
  for (Index c = 0; c < body_coordinates; ++c) {
    const EntryKind kind = row[static_cast<std::size_t>(c)];
    if (kind == EntryKind::real || kind == EntryKind::complex) to.add(own, c, CouplingKind::in_phase);
    if (kind == EntryKind::imaginary || kind == EntryKind::complex) to.add(own, c, CouplingKind::cross);
  }
}

/// leftᴴ x right and its conjugate transpose, x real, are added to the entries of the body: real times imaginary
/// couples across, kinds alike in phase. No entries of both parts.
inline void add_product(Couplings& to, const RowKinds& left, const RowKinds& right) {
  for (Index i = 0; i < body_coordinates; ++i) {
    for (Index k = 0; k < body_coordinates; ++k) {
      const EntryKind a = left[static_cast<std::size_t>(i)], b = right[static_cast<std::size_t>(k)];
      if (a == EntryKind::none || b == EntryKind::none) continue;
      to.add(i, k, a == b ? CouplingKind::in_phase : CouplingKind::cross);
    }
  }
}

}  // namespace gyromode
