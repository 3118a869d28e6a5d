#include "gyromode/models/matrix_parameters.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

// Calls see(i, j) for the entries of `m` that `key` names; the diagonal of a skew matrix is none.
template <class See>
void each_named(const MatrixOfParameters& m, std::string_view key, See&& see) {
  const auto at = indices_of(m.name, key);
  if (!at || at->size() != 2) return;
  const auto range = [&](std::ptrdiff_t index) {
    return index < 0 ? std::pair<Index, Index>(0, m.matrix->rows())
                     : std::pair<Index, Index>(index, std::min<Index>(index + 1, m.matrix->rows()));
  };
  const bool several = (*at)[0] < 0 || (*at)[1] < 0;
  const auto [i0, i1] = range((*at)[0]);
  const auto [j0, j1] = range((*at)[1]);
  for (Index i = i0; i < i1; ++i) {
    for (Index j = j0; j < j1; ++j) {
      // [*] names an entry and its mirror image once, as the one above the diagonal.
      if (!m.skew || (several ? i < j : i != j)) see(i, j);
    }
  }
}

Parameter entry(const MatrixOfParameters& m, Index i, Index j) {
  return {fmt::format("{}[{}][{}]", m.name, i, j), std::nullopt, (*m.matrix)(i, j)};
}

}  // namespace

std::vector<Parameter> listed_entries(const std::vector<MatrixOfParameters>& matrices) {
  constexpr Index worth_listing = 12;
  std::vector<Parameter> all;
  for (const MatrixOfParameters& m : matrices) {
    const Index shown = m.matrix->rows() <= worth_listing ? m.matrix->rows() : std::min<Index>(2, m.matrix->rows());
    for (Index i = 0; i < shown; ++i) {
      for (Index j = m.skew ? i + 1 : i; j < shown; ++j) all.push_back(entry(m, i, j));
    }
  }
  return all;
}

std::optional<Parameter> entry_named(const std::vector<MatrixOfParameters>& matrices, std::string_view key) {
  std::optional<Parameter> first;
  for (const MatrixOfParameters& m : matrices) {
    each_named(m, key, [&](Index i, Index j) {
      if (!first) first = entry(m, i, j);
    });
  }
  return first;
}

bool set_entries(const std::vector<MatrixOfParameters>& matrices, const ParameterValue& value) {
  bool any = false;
  for (const MatrixOfParameters& m : matrices) {
    each_named(m, value.key, [&](Index i, Index j) {
      (*m.matrix)(i, j) = value.value;
      (*m.matrix)(j, i) = m.skew ? -value.value : value.value;
      any = true;
    });
  }
  return any;
}

bool entries_have(const std::vector<MatrixOfParameters>& matrices, const ParameterValue& value) {
  bool all = true;
  for (const MatrixOfParameters& m : matrices)
    each_named(m, value.key, [&](Index i, Index j) { all = all && (*m.matrix)(i, j) == value.value; });
  return all;
}

}  // namespace gyromode
