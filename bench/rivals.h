#pragma once

#include "gyromode/system/system.h"

namespace gyromode::bench {

/// LAPACK's drivers as a user would call them, on copies made before the clock starts: `reset` copies, `solve`
/// overwrites.

/// LAPACKE_dsyevd(COL_MAJOR, jobz V, uplo L): all eigenvalues and vectors of a symmetric matrix.
class Dsyevd {
 public:
  explicit Dsyevd(Matrix a);
  void reset();
  void solve();

  static constexpr const char* options = "LAPACKE_dsyevd, jobz V, uplo L";
  const Vector& values() const { return values_; }
  const Matrix& vectors() const { return work_; }

 private:
  Matrix a_, work_;
  Vector values_;
};

/// LAPACKE_dsygvd(COL_MAJOR, itype 1, jobz V, uplo L): A x = λ B x, B > 0.
class Dsygvd {
 public:
  Dsygvd(Matrix a, Matrix b);
  void reset();
  void solve();

  static constexpr const char* options = "LAPACKE_dsygvd, itype 1, jobz V, uplo L";
  const Vector& values() const { return values_; }
  const Matrix& vectors() const { return work_a_; }

 private:
  Matrix a_, b_, work_a_, work_b_;
  Vector values_;
};

/// LAPACKE_dgeev(COL_MAJOR, jobvl N, jobvr V): all eigenvalues and right vectors of a real matrix.
class Dgeev {
 public:
  explicit Dgeev(Matrix a);
  void reset();
  void solve();

  static constexpr const char* options = "LAPACKE_dgeev, jobvl N, jobvr V";
  /// Positions k with Im λ_k > 0, λ_k and its vector.
  std::vector<Index> upper() const;
  Complex value(Index k) const { return {re_(k), im_(k)}; }
  ComplexVector vector(Index k) const;

 private:
  Matrix a_, work_, vectors_;
  Vector re_, im_;
};

/// [−M⁻¹G −M⁻¹K; 1 0] of z = (q̇, q) (Willems et al. 1975).
Matrix companion(const System& system);

}  // namespace gyromode::bench
