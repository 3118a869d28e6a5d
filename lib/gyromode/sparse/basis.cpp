#include "gyromode/sparse/basis.h"

namespace gyromode::sparse {

ComplexVector in_given(const Basis& b, const ComplexVector& p) {
  const ComplexVector w = unfolded(b.fold, p);
  if (!b.turn) return w;
  return *b.turn * w;
}

}  // namespace gyromode::sparse
