#include "gyromode/sparse/basis.h"

#include "gyromode/sparse/matrix.h"

namespace gyromode::sparse {

ComplexVector in_given(const SparseSystem& s, const ComplexVector& p) {
  if (!s.basis()) return p;
  const ComplexVector w = unfolded(s.basis()->fold, p);
  if (!s.basis()->turn) return w;
  return *s.basis()->turn * w;
}

Matrix from_given(const SparseSystem& s, const Matrix& q) {
  if (!s.basis()) return q;
  return folded(s.basis()->fold, s.basis()->turn ? transposed_times(*s.basis()->turn, q) : q);
}

}  // namespace gyromode::sparse
