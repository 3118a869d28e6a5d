#include "gyromode/lapack/reflectors.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/team.h"

#include <cblas.h>

#include <algorithm>
#include <atomic>
#include <optional>
#include <vector>

namespace gyromode::lapack {

namespace {

constexpr Index panel_width = 64;

// H_start … H_{start+width−1} = 1 − V U⁻¹ Vᵀ on the rows from start + first on. U = T⁻¹ is upper triangular: the strict
// upper part of VᵀV, and 1/τ on the diagonal.
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
    u = multiply_tn(v, v);
    for (Index i = 0; i < width; ++i) u(i, i) = q.tau(start + i) == 0 ? 1 : 1 / q.tau(start + i);
  }

  void solve(CBLAS_SIDE side, MatrixSpan y) const {
    if (y.size() == 0) return;
    cblas_dtrsm(CblasColMajor, side, CblasUpper, CblasNoTrans, CblasNonUnit, dimension(y.rows(), "dtrsm"), dimension(y.cols(), "dtrsm"), 1,
                u.data(), dimension(u.rows(), "dtrsm"), y.data(), dimension(y.outerStride(), "dtrsm"));
  }
};

// All panels, made at once: each is work for one thread.
std::vector<std::optional<Panel>> panels_of(const Reflectors& q, Team& team) {
  std::vector<std::optional<Panel>> panels(static_cast<std::size_t>((q.tau.size() + panel_width - 1) / panel_width));
  std::atomic<std::size_t> next = 0;
  team.run([&](int) {
    for (std::size_t k = next++; k < panels.size(); k = next++) {
      const Index start = static_cast<Index>(k) * panel_width;
      panels[k].emplace(q, start, std::min(panel_width, q.tau.size() - start));
    }
  });
  return panels;
}

}  // namespace

void multiply_right(MatrixSpan x, const Reflectors& q) {
  Team team(threads_for(q.size()));
  const auto panels = panels_of(q, team);
  for (const auto& panel : panels) {
    team.run([&](int part) {
      auto rows = x.middleRows(team.begin(x.rows(), part), team.count(x.rows(), part)).rightCols(panel->v.rows());
      Matrix y = multiply(rows, panel->v);
      panel->solve(CblasRight, y);
      multiply_into(rows, -1, y, false, panel->v, true, 1);
    });
  }
}

void multiply_left(const Reflectors& q, MatrixSpan x) {
  Team team(threads_for(q.size()));
  const auto panels = panels_of(q, team);
  // A thread goes through all panels with its columns of x: none waits for another.
  team.run([&](int part) {
    const Index width = team.count(x.cols(), part);
    Matrix y(panel_width, width);
    for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel) {
      const Matrix& v = (*panel)->v;
      auto columns = x.middleCols(team.begin(x.cols(), part), width).bottomRows(v.rows());
      auto z = y.topRows(v.cols());
      multiply_into(z, 1, v, true, columns, false, 0);
      (*panel)->solve(CblasLeft, z);
      multiply_into(columns, -1, v, false, z, false, 1);
    }
  });
}

}  // namespace gyromode::lapack
