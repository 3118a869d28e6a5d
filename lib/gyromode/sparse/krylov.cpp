#include "gyromode/sparse/krylov.h"

#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/orthonormal.h"

#include <cmath>

namespace gyromode::sparse {

namespace {

// A frequency of the size of the motions that a block of shapes has when nothing but K acts; 1 where there is none.
double typical(const SparseSystem& s, const Matrix& x) {
  const double k = std::abs((x.transpose() * symmetric_times(s.stiffness(), x)).trace()),
               m = (x.transpose() * symmetric_times(s.mass(), x)).trace();
  return k > 0 && m > 0 ? std::sqrt(k / m) : 1;
}

}  // namespace

// With a partition the first states move in phase and have velocities in quadrature: what follows keeps to that.
void Krylov::start(const Matrix& shapes) {
  const ComplexMatrix r = (-symmetric_times(system_.mass(), shapes)).cast<Complex>();
  Matrix x = resolvent_.solve(r).real();
  if (groups_.partition) {
    for (const Index i : groups_.rows[1]) x.row(i).setZero();
  }
  if (scale_ == 0) scale_ = resolvent_.shift > 0 ? resolvent_.shift : typical(system_, x);
  for (Index j = 0; j < x.cols(); ++j) {
    const double size = x.col(j).norm();
    if (size > 0) x.col(j) /= size;
  }
  const Matrix c = v_.add(x);
  Matrix state = stacked(c, Matrix::Zero(c.rows(), c.cols()));
  ended_ = !orthonormalise(state);
  if (!ended_) states_.push_back(std::move(state));
}

void Krylov::restart(const Matrix& displacement, const Matrix& velocity) {
  states_.clear();
  ended_ = true;
  if (displacement.cols() == 0) return;
  Matrix both(displacement.rows(), 2 * displacement.cols());
  both << displacement, velocity;
  const Matrix c = v_.add(both);
  Matrix state = stacked(c.leftCols(displacement.cols()), c.rightCols(displacement.cols()));
  ended_ = !orthonormalise(state);
  if (!ended_) states_.push_back(std::move(state));
}

Matrix Krylov::stacked(const Matrix& q, const Matrix& v) const {
  Matrix s(2 * q.rows(), q.cols());
  s << scale_ * q, v;
  return s;
}

Matrix Krylov::extended(const Matrix& state, Index rows) {
  const Index half = state.rows() / 2;
  Matrix s = Matrix::Zero(2 * rows, state.cols());
  s.topRows(half) = state.topRows(half);
  s.middleRows(rows, half) = state.bottomRows(half);
  return s;
}

// Columns of size 1 against all states twice, then among themselves: what is left of one below 10⁻¹⁰ is rounding. False
// where nothing is left.
bool Krylov::orthonormalise(Matrix& state) const {
  const Index rows = state.rows() / 2;
  for (Index j = 0; j < state.cols(); ++j) {
    const double size = state.col(j).norm();
    if (size > 0) state.col(j) /= size;
  }
  for (const double least : {1e-20, 1e-4}) {
    for (const Matrix& s : states_) {
      const Matrix e = extended(s, rows);
      state -= e * (e.transpose() * state);
    }
    const Matrix c = orthonormal_combinations(state.transpose() * state, least);
    if (c.cols() == 0) return false;
    state = state * c;
  }
  return true;
}

bool Krylov::step() {
  if (ended_ || states_.empty()) return false;
  const Matrix last = extended(states_.back(), v_.size()), f1 = displacement(last), f2 = velocity(last);
  const Matrix m1 = v_.mass_times(f1), m2 = v_.mass_times(f2), g1 = skew_times(system_.gyroscopic(), v_.combined(f1));
  const double sigma = resolvent_.shift;
  const Complex j(0, 1);
  const ComplexMatrix q = resolvent_.solve(ComplexMatrix(-(m2 + g1).cast<Complex>() - (j * sigma) * m1));
  Matrix state;
  if (sigma > 0) {
    Matrix both(q.rows(), 2 * q.cols());
    both << q.imag() / sigma, q.real();
    const Matrix c = v_.add(both);
    state = stacked(c.leftCols(q.cols()), c.rightCols(q.cols()));
  } else {
    const Matrix c = v_.add(q.real());
    Matrix velocities = Matrix::Zero(c.rows(), c.cols());
    velocities.topRows(f1.rows()) = f1;
    state = stacked(c, velocities);
  }
  ended_ = !orthonormalise(state);
  if (ended_) return false;
  states_.push_back(std::move(state));
  return true;
}

}  // namespace gyromode::sparse
