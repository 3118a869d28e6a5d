#include "gyromode/sparse/motions.h"

namespace gyromode::sparse {

ShapeBlock motions_of(const Groups& groups, StateKind kind, const Vector& omega, const Matrix& states, const Matrix& other_states) {
  if (kind.pairs) {
    const Index n = states.rows() / 2;
    return {omega, states.topRows(n), other_states.topRows(n)};
  }
  ShapeBlock b{omega, Matrix::Zero(states.rows(), states.cols()), Matrix::Zero(states.rows(), states.cols())};
  for (Index j = 0; j < states.cols(); ++j) {
    const double re = kind.leads == 0 ? 1 : 1 / omega(j), im = kind.leads == 0 ? -1 / omega(j) : 1;
    for (const Index i : groups.rows[0]) b.re(i, j) = re * states(i, j);
    for (const Index i : groups.rows[1]) b.im(i, j) = im * states(i, j);
  }
  return b;
}

StatesOfMotions states_of(const Groups& groups, StateKind kind, const ShapeBlock& b) {
  const Index n = b.re.rows(), m = b.re.cols();
  StatesOfMotions s;
  if (kind.pairs) {  // z = (X, jωX)
    s.first.resize(2 * n, m);
    s.second.resize(2 * n, m);
    s.first << b.re, -(b.im * b.omega.asDiagonal());
    s.second << b.im, b.re * b.omega.asDiagonal();
    return s;
  }
  s.first.resize(n, m);
  for (Index j = 0; j < m; ++j) {
    const double re = kind.leads == 0 ? 1 : b.omega(j), im = kind.leads == 0 ? -b.omega(j) : 1;
    for (const Index i : groups.rows[0]) s.first(i, j) = re * b.re(i, j);
    for (const Index i : groups.rows[1]) s.first(i, j) = im * b.im(i, j);
  }
  return s;
}

}  // namespace gyromode::sparse
