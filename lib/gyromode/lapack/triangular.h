#pragma once

#include "gyromode/base/types.h"

#include <optional>

namespace gyromode::lapack {

/// Cholesky factorisation A = L Lᵀ of a symmetric matrix (n × n, lower triangle read); A is overwritten by L, zeros
/// above. Returns nothing where A is positive definite, else the position of the first pivot that is not positive
/// (dpotrf).
std::optional<Index> cholesky(MatrixSpan a);

/// A = L Lᵀ kept for what is asked of it later.
class Cholesky {
 public:
  /// Lower triangle read.
  explicit Cholesky(Matrix a);

  /// Whether A is positive definite; if not, nothing else may be asked.
  bool positive() const { return positive_; }
  const Matrix& lower() const { return l_; }
  /// A⁻¹b.
  Matrix solve(Matrix b) const;

 private:
  Matrix l_;
  bool positive_;
};

/// Reciprocal condition number (1-norm) of A = L Lᵀ whose 1-norm is `norm` (dpocon).
double reciprocal_condition(const MatrixView& l, double norm);

/// b := L⁻¹ b and b := L⁻ᵀ b, L lower triangular n × n, b n × m (dtrsm).
void solve_lower(const MatrixView& l, MatrixSpan b);
void solve_lower_transposed(const MatrixView& l, MatrixSpan b);
/// b := b L⁻ᵀ, b m × n.
void solve_lower_transposed_right(const MatrixView& l, MatrixSpan b);
/// b := Lᵀ b.
void multiply_lower_transposed(const MatrixView& l, MatrixSpan b);
/// b := b L.
void multiply_lower_right(const MatrixView& l, MatrixSpan b);

/// LᵀL for lower triangular L (n × n), the lower triangle only: what stands above it is not defined (dlauum).
Matrix gram_of_lower(Matrix l);

/// L⁻¹ A L⁻ᵀ for symmetric A (n × n, lower triangle read), symmetric to the last bit (dsygst).
Matrix congruence(const MatrixView& l, Matrix a);

/// An orthogonal n × n matrix whose first columns span the columns of `a` (n × r, r ≤ n, full rank; Householder QR).
Matrix orthogonal_completion(const MatrixView& a);

/// Orthonormal columns (n × r) that span those of `a` (n × r, r ≤ n, full rank; dgeqrf, dorgqr).
Matrix orthonormal_columns(Matrix a);

/// A⁻¹ b, A n × n general, b n × m (dgesv). Throws NotConverged where A is singular to the last bit.
Matrix solve_general(Matrix a, Matrix b);

}  // namespace gyromode::lapack
