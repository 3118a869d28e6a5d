#include "gyromode/lapack/reflectors.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"

#include <cblas.h>

#include <algorithm>

namespace gyromode::lapack {

namespace {

// Measured on two threads: wider panels pay where a panel's products are shared out worse.
Index panel_width(Index n) { return n < 1500 ? 96 : 192; }

// H_start … H_{start+width−1} = 1 − V U⁻¹ Vᵀ on the rows from start + first on. U = T⁻¹ is upper triangular: the strict upper part of VᵀV, and 1/τ on the diagonal.
struct Panel {
  Matrix v, u;

  Panel(const Reflectors& q, Index start, Index width) : v(q.size() - start - q.first, width) {
    const Index rows = v.rows();
    for (Index i = 0; i < width; ++i) {
      v.col(i).head(i).setZero();
      if (q.tau(start + i) == 0) {  // H = 1
        v.col(i).setZero();
      } else {
        v(i, i) = 1;
        v.col(i).tail(rows - i - 1) = q.vectors.col(start + i).tail(rows - i - 1);
      }
    }
    u = gram(v);
    for (Index i = 0; i < width; ++i) u(i, i) = q.tau(start + i) == 0 ? 1 : 1 / q.tau(start + i);
  }

  void solve(CBLAS_SIDE side, MatrixSpan y) const {
    if (y.size() == 0) return;
    cblas_dtrsm(CblasColMajor, side, CblasUpper, CblasNoTrans, CblasNonUnit, dimension(y.rows(), "dtrsm"), dimension(y.cols(), "dtrsm"), 1, u.data(),
                dimension(u.rows(), "dtrsm"), y.data(), dimension(y.outerStride(), "dtrsm"));
  }
};

}  // namespace

void multiply_right(MatrixSpan x, const Reflectors& q) {
  const Index step = panel_width(q.size());
  for (Index start = 0; start < q.tau.size(); start += step) {
    const Panel panel(q, start, std::min(step, q.tau.size() - start));
    auto columns = x.rightCols(panel.v.rows());
    Matrix y = multiply(columns, panel.v);
    panel.solve(CblasRight, y);
    multiply_into(columns, -1, y, false, panel.v, true, 1);
  }
}

void multiply_left(const Reflectors& q, MatrixSpan x) {
  const Index step = panel_width(q.size());
  for (Index end = q.tau.size(); end > 0;) {
    const Index start = (end - 1) / step * step;
    const Panel panel(q, start, end - start);
    auto rows = x.bottomRows(panel.v.rows());
    Matrix y = multiply_tn(panel.v, rows);
    panel.solve(CblasLeft, y);
    multiply_into(rows, -1, panel.v, false, y, false, 1);
    end = start;
  }
}

}  // namespace gyromode::lapack
