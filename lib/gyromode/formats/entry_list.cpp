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

// n n entries, before them: the size line of Matrix Market without its banner.
bool is_size_line(const Table& rows) {
  const std::vector<double>& first = rows.front();
  if (first.size() != 3 || rows.size() < 2 || first[0] != first[1] || first[2] != static_cast<double>(rows.size() - 1)) return false;
  return std::all_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[0] <= first[0] && row[1] <= first[0]; });
}

}  // namespace

std::optional<NamedMatrix> entry_list(const Table& rows, const std::filesystem::path& name, std::optional<Index> most) {
  const std::size_t columns = rows.front().size();
  if (rows.size() < 2 || (columns != 3 && columns != 5) || symmetric_or_skew(rows)) return std::nullopt;
  const bool by_nodes = columns == 5, sized = is_size_line(rows);
  if (sized && std::none_of(rows.begin() + 1, rows.end(), [&](const auto& row) { return row[0] == rows[0][0] && row[1] == rows[0][1]; }))
    throw Unreadable(name, fmt::format("the first line, {0:g} {0:g} {1:g}, may be sizes or an entry: leave it out, or put the line "
                                       "%%MatrixMarket matrix coordinate real symmetric (general, skew-symmetric) before it",
                                       rows[0][0], rows[0][2]));
  std::set<Dof> dofs;
  std::set<std::pair<Dof, Dof>> seen;
  Index on_diagonal = 0, largest = sized ? static_cast<Index>(rows.front()[0]) : 0;
  bool any_on_diagonal = false;  // that is not 0
  for (auto row = rows.begin() + (sized ? 1 : 0); row != rows.end(); ++row) {
    const auto i = dof_of(*row, 0, by_nodes), j = dof_of(*row, by_nodes ? 2 : 1, by_nodes);
    if (!i || !j || !seen.insert({*i, *j}).second) return std::nullopt;
    dofs.insert({*i, *j});
    largest = std::max({largest, i->first, j->first});
    on_diagonal += *i == *j;
    any_on_diagonal = any_on_diagonal || (*i == *j && row->back() != 0);
  }
  // No pair is given both ways, on whatever side of the diagonal: each entry is its mirror image as well.
  const bool each_pair_once = std::none_of(seen.begin(), seen.end(),
                                           [&](const auto& e) {
                                             return e.first != e.second && seen.count({e.second, e.first}) > 0;
                                           }) &&
                              on_diagonal < static_cast<Index>(seen.size());
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
  for (auto row = rows.begin() + (sized ? 1 : 0); row != rows.end(); ++row)
    entries.add(place.at(*dof_of(*row, 0, by_nodes)), place.at(*dof_of(*row, by_nodes ? 2 : 1, by_nodes)), row->back());
  found.matrix = entries.dense(order, order, !each_pair_once ? 0 : any_on_diagonal ? 1 : -1);
  found.may_go_on = !by_nodes && !sized;
  return found;
}

}  // namespace gyromode::io
