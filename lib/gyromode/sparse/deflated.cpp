#include "gyromode/sparse/deflated.h"

#include "gyromode/lapack/multiply.h"

#include <Eigen/Cholesky>

namespace gyromode::sparse {

namespace {

std::vector<Index> columns_of(const std::vector<bool>& across, bool wanted) {
  std::vector<Index> all;
  for (std::size_t k = 0; k < across.size(); ++k) {
    if (across[k] == wanted) all.push_back(static_cast<Index>(k));
  }
  return all;
}

// States D that are taken away, with E D and weights L, LᵀD = 1: w loses D Lᵀw.
struct Parts {
  Matrix out, weight, e_out;

  explicit Parts(Index length) : out(length, 0), weight(length, 0), e_out(length, 0) {}
  // Columns in their rows, beside those there are.
  void add(const Matrix& d, const Matrix& l, const Matrix& ed) {
    for (const auto& [to, columns] : {std::pair(&out, &d), {&weight, &l}, {&e_out, &ed}}) {
      Matrix both(to->rows(), to->cols() + columns->cols());
      both << *to, *columns;
      *to = std::move(both);
    }
  }
  // States with ⟨D, D⟩ of their own: taken away E-orthogonally.
  void add_orthogonally(const Matrix& d, const Matrix& ed) {
    if (d.cols() > 0) add(d, ed * (d.transpose() * ed).llt().solve(Matrix::Identity(d.cols(), d.cols())), ed);
  }
};

// MN₀ of N₀ in the span of N.
Matrix mass_times_drift(const FreeMotions& f, const Matrix& drift) { return f.mn * (f.mn.transpose() * drift); }

Matrix above(const Matrix& x) {
  Matrix both = Matrix::Zero(2 * x.rows(), x.cols());
  both.topRows(x.rows()) = x;
  return both;
}

Matrix stacked(const Matrix& x, const Matrix& y) {
  Matrix both(2 * x.rows(), x.cols());
  both << x, y;
  return both;
}

// Of states (q, q̇).
Parts of_pairs(const FreeMotions& f, Index n) {
  Parts p(2 * n);
  const Matrix none = Matrix::Zero(n, f.t.cols());
  p.add(above(f.n), above(f.mn), Matrix::Zero(2 * n, f.nullity()));
  p.add(above(f.t), above(f.mt), above(f.kt));
  p.add(stacked(none, f.t), stacked(none, f.mt), stacked(none, f.mt));
  p.add_orthogonally(stacked(f.response, f.drift), stacked(f.held, mass_times_drift(f, f.drift)));
  return p;
}

// Of states (x, ẏ) in the order of coordinates, x of the group that is across, `leading`, or of the other one: N and T
// of x, drift and T of ẏ.
Parts of_groups(const FreeMotions& f, Index n, bool leading) {
  const auto some = [](const Matrix& a, const std::vector<Index>& columns) { return Matrix(a(Eigen::all, columns)); };
  const std::vector<Index> still = columns_of(f.across, leading), drift = columns_of(f.drift_across, !leading),
                           t = columns_of(f.t_across, leading), t_rate = columns_of(f.t_across, !leading);
  Parts p(n);
  p.add(some(f.n, still), some(f.mn, still), Matrix::Zero(n, static_cast<Index>(still.size())));
  p.add(some(f.t, t), some(f.mt, t), some(f.kt, t));
  p.add(some(f.t, t_rate), some(f.mt, t_rate), some(f.mt, t_rate));
  const Matrix n0 = some(f.drift, drift);
  p.add_orthogonally(n0 + some(f.response, drift), some(f.held, drift) + mass_times_drift(f, n0));
  return p;
}

}  // namespace

TakenAway free_states(const FreeMotions& free, const Groups& groups, const Inverse& of) {
  const Index n = free.n.rows();
  const Parts p = groups.partition ? of_groups(free, n, of.leading_group() == 1) : of_pairs(free, n);
  const auto in_states = [&](const Matrix& x) { return groups.partition ? of.states(x) : x; };
  return {in_states(p.out), in_states(p.weight), in_states(p.e_out)};
}

States Deflated::without(States w) const {
  const Matrix c = lapack::multiply_tn(states_.weight, w.x);
  lapack::multiply_into(w.x, -1, states_.out, false, c, false, 1);
  lapack::multiply_into(w.ex, -1, states_.e_out, false, c, false, 1);
  return w;
}

}  // namespace gyromode::sparse
