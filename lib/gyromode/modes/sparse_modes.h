#pragma once

#include "gyromode/sparse/search.h"
#include "gyromode/spectrum/result.h"

#include <optional>
#include <vector>

namespace gyromode {

/// Modes of a sparse system, as searches leave them, ascending.
using SparseModes = std::vector<sparse::RitzMode>;

constexpr Index most_at_one_shift = 60;  ///< modes that one shift is asked for

/// Columns after which a search is given up: some thirty for every root, and what a bad start takes.
Index most_applied(Index wanted);

/// How many of those expected have converged.
Index converged_in(const std::vector<sparse::Search::Expected>& inside);

/// The range, where there is enough in it.
std::optional<Window> wanted_if(bool enough, const Window& range);

/// What a search finds, without what has not converged to what is asked of a mode that is listed: it may be none.
sparse::MeasuredRoots listable(sparse::Search& search, const sparse::Goal& goal, const Progress& progress);

/// A range with so many modes in it, all of which are wanted.
sparse::Goal all_of(const Window& range, Index expected);

/// The middle of the first gap after `count` of ascending roots that is wider than their errors; 0 where there is none.
double gap_after(const SparseModes& roots, Index count);

/// The error of a root: its bound, and not less than rounding of ω.
double error_of(const sparse::RitzMode& m);

/// A mode of a result, its shape in the coordinates given.
Mode mode_of(const SparseSystem& system, const sparse::RitzMode& m, bool with_shape);

}  // namespace gyromode
