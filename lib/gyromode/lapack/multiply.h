#pragma once

#include "gyromode/base/types.h"

namespace gyromode::lapack {

/// Products of dense matrices by the BLAS (dgemm, dsyrk). Shapes as in the formulas.
Matrix multiply(const MatrixView& a, const MatrixView& b);                       ///< A B
Matrix multiply_tn(const MatrixView& a, const MatrixView& b);                    ///< Aᵀ B
Matrix multiply_nt(const MatrixView& a, const MatrixView& b);                    ///< A Bᵀ
ComplexMatrix multiply_complex(const ComplexMatrix& a, const ComplexMatrix& b);  ///< A B (zgemm)
ComplexMatrix multiply_adjoint(const ComplexMatrix& a, const ComplexMatrix& b);  ///< Aᴴ B
/// c := α·op(A)·op(B) + β·c with op the transpose where the flag says so.
void multiply_into(MatrixSpan c, double alpha, const MatrixView& a, bool transpose_a, const MatrixView& b, bool transpose_b, double beta);
/// y := y + α·op(A)·x (dgemv).
void multiply_add(Eigen::Ref<Vector> y, double alpha, const MatrixView& a, bool transpose,
                  const Eigen::Ref<const Vector, 0, Eigen::InnerStride<>>& x);
/// AᵀA, both triangles, or the lower one only (what stands above it is not defined).
Matrix gram(const MatrixView& a);
Matrix gram_lower(const MatrixView& a);
/// Copies the lower triangle onto the upper one, in place.
void mirror_lower(MatrixSpan a);

}  // namespace gyromode::lapack
