#pragma once

#include "gyromode/modes/sparse_counts.h"

#include <optional>

namespace gyromode {

/// Modes of an interior window where K ≥ 0, about shifts inside it. n₋(H) is known at every shift from its
/// factorisation; beyond the outermost ones counts of modes at rest, which take a fraction of that, show that nothing
/// is missing as far as modes leave a gap there (theory sparse §5, T17).
class SparseSlices {
 public:
  SparseSlices(const SparseSystem& system, const sparse::Searches& searches, const SparseBalance& balance, SparseCounts& counts,
               const Progress& progress)
      : system_(system), searches_(searches), balance_(balance), counts_(counts), progress_(progress) {}

  /// Whether it applies to a window.
  bool serve(const Window& window) const;

  /// The modes of a window and some beyond, ascending, without one between that is known to be missing.
  struct Found {
    SparseModes modes;
    /// Where the user stopped the work: what was searched. Else empty.
    std::optional<Window> stopped;
  };
  /// What is proved of them `counts` knows from then on. Nothing where shifts did not do.
  std::optional<Found> about_middles(const Window& window);

 private:
  struct Slice {
    double shift = 0;
    Index below = 0;      // modes below the shift, by count
    bool lowest = false;  // its first mode is the lowest there is
    SparseModes modes;    // all between the first and the last
  };
  enum class End { reached, stopped, failed };

  std::optional<Slice> slice(const Window& window);
  End cover(const Window& window, int depth);
  SparseModes joined() const;
  void prove(const Window& window, const SparseModes& all);

  const SparseSystem& system_;
  const sparse::Searches& searches_;
  const SparseBalance& balance_;
  SparseCounts& counts_;
  const Progress& progress_;
  std::vector<Slice> slices_;  // ascending
};

}  // namespace gyromode
