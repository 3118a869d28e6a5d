// Format: Abaqus Keywords Reference Guide, *MATRIX OUTPUT and *MATRIX INPUT; CalculiX, *FREQUENCY,
// SOLVER=MATRIXSTORAGE.
#include "gyromode/formats/entry_list.h"

#include "gyromode/formats/entries.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace gyromode::io {

namespace {

using Table = std::vector<std::vector<double>>;
using Dof = std::pair<Index, Index>;  // node, direction; the position alone

std::optional<Index> whole(double x, Index least) {
  constexpr double most = 1e9;
  return x >= static_cast<double>(least) && x <= most && x == std::floor(x) ? std::optional(static_cast<Index>(x)) : std::nullopt;
}

// Such a table may be a list only if it makes no matrix as it stands.
bool symmetric_or_skew(const Table& rows) {
  if (rows.size() != rows.front().size()) return false;
  bool symmetric = true, skew = true;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t j = 0; j < rows.size(); ++j) {
      symmetric = symmetric && rows[i][j] == rows[j][i];
      skew = skew && rows[i][j] == -rows[j][i];
    }
  }
  return symmetric || skew;
}

std::optional<Dof> dof_of(const std::vector<double>& row, std::size_t first, bool by_nodes) {
  const auto a = whole(row[first], 1);
  if (!by_nodes) return a ? std::optional(Dof{*a, 0}) : std::nullopt;
  const auto b = whole(row[first + 1], 0);
  return a && b ? std::optional(Dof{*a, *b}) : std::nullopt;
}

}  // namespace

std::optional<NamedMatrix> entry_list(const Table& rows, const std::filesystem::path& name, std::optional<Index> most) {
  const std::size_t columns = rows.front().size();
  if ((columns != 3 && columns != 5) || symmetric_or_skew(rows)) return std::nullopt;
  const bool by_nodes = columns == 5;
  std::set<Dof> dofs;
  std::set<std::pair<Dof, Dof>> seen;
  Index below = 0, above = 0, on_diagonal = 0, largest = 0;
  bool any_on_diagonal = false;  // that is not 0
  for (const std::vector<double>& row : rows) {
    const auto i = dof_of(row, 0, by_nodes), j = dof_of(row, by_nodes ? 2 : 1, by_nodes);
    if (!i || !j || !seen.insert({*i, *j}).second) return std::nullopt;
    dofs.insert({*i, *j});
    largest = std::max({largest, i->first, j->first});
    ++(*i == *j ? on_diagonal : *j < *i ? below : above);
    any_on_diagonal = any_on_diagonal || (*i == *j && row[columns - 1] != 0);
  }
  const bool one_side = (below == 0) != (above == 0);
  const bool skew = one_side && !any_on_diagonal;
  if (rows.size() == columns && on_diagonal != static_cast<Index>(dofs.size())) return std::nullopt;  // may be a square matrix as well
  std::map<Dof, Index> place;
  NamedMatrix found{name.stem().string(), {}, {}};
  for (const Dof& d : dofs) {
    place.emplace(d, by_nodes ? static_cast<Index>(place.size()) : d.first - 1);
    if (by_nodes) found.labels.push_back(fmt::format("{}.{}", d.first, d.second));
  }
  const Index order = by_nodes ? static_cast<Index>(dofs.size()) : largest;
  Entries entries(name, most);
  entries.require_size(order, order, static_cast<Index>(rows.size()));
  for (const std::vector<double>& row : rows)
    entries.add(place.at(*dof_of(row, 0, by_nodes)), place.at(*dof_of(row, by_nodes ? 2 : 1, by_nodes)), row[columns - 1]);
  found.matrix = entries.dense(order, order, skew ? -1 : one_side ? 1 : 0);
  return found;
}

}  // namespace gyromode::io
