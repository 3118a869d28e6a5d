#pragma once

#include "gyromode/roots/isolate.h"

namespace gyromode {

/// The count where it begins: n₋ of each block as ω → 0⁺.
///
/// Some coordinates stand for motions that nothing holds (translation, spin phase): their own entry is a negative
/// constant at every ω and no mode is counted by it. Without them n₋ is that of the static stiffness, with ignorable
/// motions eliminated: k_r + 2k_c + 2k₋, the divergent, fluttering and negative-energy modes that the block has
/// (docs/theory.md (T12), docs/booms.md (B11)).
struct StaticCount {
  std::vector<Index> count;    ///< J(0⁺), a block
  std::vector<Index> reduced;  ///< J(0⁺) less the free coordinates: 0 where every mode has positive energy
  Index negative = 0;          ///< n₋ of the static stiffness itself, ignorable motions held, copies counted
  bool doubtful = false;       ///< an eigenvalue is zero to rounding beyond the `zeros` expected
};

/// `free`: coordinates that nothing holds; `cyclic`: those of them with gyroscopic coupling, which n₋ of the static
/// stiffness leaves out (the spin phase). `zeros`: how many static zero eigenvalues are known to be there by
/// construction; as ω leaves 0 they turn negative.
StaticCount static_count(const BlockedImpedance& h, const std::vector<Index>& free, const std::vector<Index>& cyclic, Index zeros);

}  // namespace gyromode
