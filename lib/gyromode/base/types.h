#pragma once

#include <Eigen/Core>

#include <complex>

namespace gyromode {

/// Sizes and positions are 64-bit; the BLAS takes 32-bit dimensions, which lapack::dimension() checks.
using Index = Eigen::Index;

using Matrix = Eigen::MatrixXd;  ///< real, column-major
using Vector = Eigen::VectorXd;
using Complex = std::complex<double>;
using ComplexMatrix = Eigen::MatrixXcd;
using ComplexVector = Eigen::VectorXcd;

/// Read-only views that accept a matrix or a block of one without a copy.
using MatrixView = Eigen::Ref<const Matrix, 0, Eigen::OuterStride<>>;
using MatrixSpan = Eigen::Ref<Matrix, 0, Eigen::OuterStride<>>;

}  // namespace gyromode
