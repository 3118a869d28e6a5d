// What modes of a sparse system would take, by analyses alone.
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/shifted.h"

namespace gyromode {

namespace {

PlannedFactorisation planned(std::string_view what, Index order, const sparse::SymmetricFactor& f) {
  return {what, order, f.entries(), f.megabytes(), f.megabytes_beside_files(), f.megabytes_in_files()};
}

}  // namespace

std::vector<PlannedFactorisation> plan_of(const SparseSystem& s) {
  using sparse::SymmetricFactor;
  const sparse::Groups groups = sparse::groups_of(sparse::analyse(s), s.size());
  std::vector<PlannedFactorisation> all;
  constexpr std::string_view names[] = {"K, in phase", "K, in quadrature"};
  for (std::size_t g = 0; g < 2; ++g) {
    const std::vector<Index>& rows = groups.rows[g];
    if (rows.empty()) continue;
    const SparseMatrix block = sparse::restricted(s.stiffness(), rows);
    if (block.nonZeros() == 0) continue;
    const SymmetricFactor k(block, sparse::elimination_order(s, rows), SymmetricFactor::Keep::factors, SymmetricFactor::Kind::definite);
    all.push_back(planned(groups.partition ? names[g] : "K", static_cast<Index>(rows.size()), k));
  }
  const auto h = sparse::ShiftedImpedance(s, groups).analysed();
  all.push_back(planned(groups.partition ? "H*(ω)" : "H(ω), real", groups.partition ? s.size() : 2 * s.size(), *h));
  return all;
}

}  // namespace gyromode
