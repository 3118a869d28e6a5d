#pragma once

#include "gyromode/sparse/searches.h"
#include "gyromode/spectrum/verdict.h"

#include <string>
#include <vector>

namespace gyromode {

/// The index balance of a sparse system, n₋(K) = k_r + 2k_c + 2k₋ + n₋(F) (theory T12), with the motions that make it:
/// those of negative energy and those that grow are looked for near ω = 0 until it closes.
class SparseBalance {
 public:
  SparseBalance(const SparseSystem& system, const sparse::Searches& searches, const Progress& progress);

  const IndexBalance& index() const { return index_; }
  const std::vector<sparse::RitzMode>& negative() const { return negative_; }      ///< modes of negative energy
  const std::vector<sparse::RitzUnstable>& unstable() const { return unstable_; }  ///< that were shown to exist
  /// Why it is open, for people.
  std::string open_reason() const;
  /// By how many more modes than n₋(H) changes a window has.
  Index missed_by_signs(const Window& range) const;

 private:
  void close(const Progress& progress);
  void close_farther(double farthest, const Progress& progress);
  /// What the motions found make of it. @returns whether it is closed
  bool take(const sparse::MeasuredRoots& found);
  Index exhibited() const { return index_.real_pairs + 2 * index_.quadruples + 2 * index_.negative_energy + index_.zero_negative; }

  const SparseSystem& system_;
  const sparse::Searches& searches_;
  IndexBalance index_;
  std::vector<sparse::RitzMode> negative_;
  std::vector<sparse::RitzUnstable> unstable_;
};

}  // namespace gyromode
