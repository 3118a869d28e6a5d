#include "gyromode/lapack/multiply.h"

#include "gyromode/lapack/status.h"

#include <cblas.h>

#include <algorithm>

namespace gyromode::lapack {

void multiply_into(MatrixSpan c, double alpha, const MatrixView& a, bool transpose_a, const MatrixView& b, bool transpose_b, double beta) {
  const Index inner = transpose_a ? a.rows() : a.cols();
  eigen_assert(inner == (transpose_b ? b.cols() : b.rows()));
  if (c.size() == 0) return;
  if (inner == 0) {
    if (beta == 0) {
      c.setZero();
    } else {
      c *= beta;
    }
    return;
  }
  cblas_dgemm(CblasColMajor, transpose_a ? CblasTrans : CblasNoTrans, transpose_b ? CblasTrans : CblasNoTrans, dimension(c.rows(), "dgemm"),
              dimension(c.cols(), "dgemm"), dimension(inner, "dgemm"), alpha, a.data(), dimension(a.outerStride(), "dgemm"), b.data(),
              dimension(b.outerStride(), "dgemm"), beta, c.data(), dimension(c.outerStride(), "dgemm"));
}

void multiply_add(Eigen::Ref<Vector> y, double alpha, const MatrixView& a, bool transpose,
                  const Eigen::Ref<const Vector, 0, Eigen::InnerStride<>>& x) {
  if (a.size() == 0) return;
  cblas_dgemv(CblasColMajor, transpose ? CblasTrans : CblasNoTrans, dimension(a.rows(), "dgemv"), dimension(a.cols(), "dgemv"), alpha,
              a.data(), dimension(a.outerStride(), "dgemv"), x.data(), dimension(x.innerStride(), "dgemv"), 1, y.data(), 1);
}

Matrix multiply(const MatrixView& a, const MatrixView& b) {
  Matrix c(a.rows(), b.cols());
  multiply_into(c, 1, a, false, b, false, 0);
  return c;
}

namespace {

ComplexMatrix complex_product(const ComplexMatrix& a, CBLAS_TRANSPOSE transpose_a, const ComplexMatrix& b) {
  const Index rows = transpose_a == CblasNoTrans ? a.rows() : a.cols(), inner = b.rows();
  ComplexMatrix c = ComplexMatrix::Zero(rows, b.cols());
  if (c.size() == 0 || inner == 0) return c;
  const Complex one(1), zero(0);
  cblas_zgemm(CblasColMajor, transpose_a, CblasNoTrans, dimension(rows, "zgemm"), dimension(b.cols(), "zgemm"), dimension(inner, "zgemm"),
              &one, a.data(), dimension(a.rows(), "zgemm"), b.data(), dimension(b.rows(), "zgemm"), &zero, c.data(),
              dimension(rows, "zgemm"));
  return c;
}

}  // namespace

ComplexMatrix multiply_complex(const ComplexMatrix& a, const ComplexMatrix& b) { return complex_product(a, CblasNoTrans, b); }
ComplexMatrix multiply_adjoint(const ComplexMatrix& a, const ComplexMatrix& b) { return complex_product(a, CblasConjTrans, b); }

Matrix multiply_tn(const MatrixView& a, const MatrixView& b) {
  Matrix c(a.cols(), b.cols());
  multiply_into(c, 1, a, true, b, false, 0);
  return c;
}

Matrix multiply_nt(const MatrixView& a, const MatrixView& b) {
  Matrix c(a.rows(), b.rows());
  multiply_into(c, 1, a, false, b, true, 0);
  return c;
}

Matrix gram_lower(const MatrixView& a) {
  const Index n = a.cols();
  Matrix c(n, n);
  if (a.rows() == 0) c.setZero();
  if (c.size() == 0 || a.rows() == 0) return c;
  cblas_dsyrk(CblasColMajor, CblasLower, CblasTrans, dimension(n, "dsyrk"), dimension(a.rows(), "dsyrk"), 1, a.data(),
              dimension(a.outerStride(), "dsyrk"), 0, c.data(), dimension(n, "dsyrk"));
  return c;
}

Matrix gram(const MatrixView& a) {
  Matrix c = gram_lower(a);
  mirror_lower(c);
  return c;
}

void mirror_lower(MatrixSpan a) {
  const Index n = a.rows();
  const Index block = 32;  // keeps the transposed accesses in cache
  for (Index jb = 0; jb < n; jb += block) {
    const Index width = std::min(block, n - jb);
    for (Index ib = jb; ib < n; ib += block) {
      const Index height = std::min(block, n - ib);
      for (Index j = jb; j < jb + width; ++j) {
        for (Index i = std::max(ib, j + 1); i < ib + height; ++i) a(j, i) = a(i, j);
      }
    }
  }
}

}  // namespace gyromode::lapack
