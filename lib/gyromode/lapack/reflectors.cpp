#include "gyromode/lapack/reflectors.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/team.h"

#include <cblas.h>

#include <algorithm>

namespace gyromode::lapack {

namespace {

constexpr Index panel_width = 64;

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
  Team team(threads_for(q.size()));
  for (Index start = 0; start < q.tau.size(); start += panel_width) {
    const Panel panel(q, start, std::min(panel_width, q.tau.size() - start));
    team.run([&](int part) {
      auto rows = x.middleRows(team.begin(x.rows(), part), team.count(x.rows(), part)).rightCols(panel.v.rows());
      Matrix y = multiply(rows, panel.v);
      panel.solve(CblasRight, y);
      multiply_into(rows, -1, y, false, panel.v, true, 1);
    });
  }
}

void multiply_left(const Reflectors& q, MatrixSpan x) {
  Team team(threads_for(q.size()));
  for (Index end = q.tau.size(); end > 0;) {
    const Index start = (end - 1) / panel_width * panel_width;
    const Panel panel(q, start, end - start);
    team.run([&](int part) {
      auto columns = x.middleCols(team.begin(x.cols(), part), team.count(x.cols(), part)).bottomRows(panel.v.rows());
      Matrix y = multiply_tn(panel.v, columns);
      panel.solve(CblasLeft, y);
      multiply_into(columns, -1, panel.v, false, y, false, 1);
    });
    end = start;
  }
}

}  // namespace gyromode::lapack
