#include "sparse/as_dense.h"

#include "gyromode/modes/modes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gyromode::support {

SparseMatrix lower_of(const Matrix& a, bool with_diagonal) {
  std::vector<Eigen::Triplet<double>> entries;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = with_diagonal ? j : j + 1; i < a.rows(); ++i) {
      if (a(i, j) != 0) entries.emplace_back(static_cast<int>(i), static_cast<int>(j), a(i, j));
    }
  }
  SparseMatrix s(a.rows(), a.cols());
  s.setFromTriplets(entries.begin(), entries.end());
  return s;
}

bool expect_as_dense(const Matrix& m, const Matrix& g, const Matrix& k, const std::string& which) {
  const ModesResult dense = find_modes(System(m, g, k));
  const bool zero_and_negative = dense.index_balance.zero > 0 && dense.index_balance.negative > 0;
  if (dense.stability == Stability::unknown || (dense.stability == Stability::marginal && !zero_and_negative)) return false;
  const std::vector<double> all = dense.frequencies();
  const auto zero = static_cast<std::size_t>(dense.index_balance.zero), last = zero + (all.size() - zero) / 4;
  if (last + 1 >= all.size()) return false;
  ModesOptions o;
  o.window.b = 0.5 * (all[last] + all[last + 1]);
  const ModesResult r = find_modes(SparseSystem({lower_of(m), lower_of(g, false), lower_of(k), {}, {}}), o);
  EXPECT_EQ(r.structure.system_class(), dense.structure.system_class()) << which;
  EXPECT_EQ(r.stability, dense.stability) << which << ": " << r.coverage.reason;
  EXPECT_EQ(r.index_balance.zero, dense.index_balance.zero) << which;
  EXPECT_EQ(r.index_balance.negative, dense.index_balance.negative) << which;
  EXPECT_TRUE(r.is_complete()) << which << ": " << r.coverage.reason;
  EXPECT_EQ(r.modes.size(), last + 1) << which;
  for (std::size_t i = 0; i < std::min(last + 1, r.modes.size()); ++i) {
    EXPECT_NEAR(r.modes[i].omega, all[i], 1e-10 * all[i] + dense.modes[i].error_bound)
        << which << " " << i << ": residual " << r.modes[i].residual << ", bound " << r.modes[i].error_bound;
    EXPECT_EQ(r.modes[i].energy_sign, dense.modes[i].energy_sign) << which << " " << i;
    EXPECT_EQ(r.modes[i].kind, dense.modes[i].kind) << which << " " << i;
    EXPECT_LT(r.modes[i].residual, 1e-10) << which << " " << i;
  }
  return true;
}

}  // namespace gyromode::support
