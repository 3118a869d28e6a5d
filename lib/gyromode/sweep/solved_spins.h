#pragma once

#include "gyromode/sweep/large_family.h"
#include "gyromode/sweep/projected_family.h"

#include <map>
#include <optional>

namespace gyromode {

/// A large family at the spins solved, each with its certificate, and its projection on their shapes.
class SolvedSpins {
 public:
  SolvedSpins(const LargeFamily& family, const CampbellOptions& options);

  /// Solves one more, and compares it with the projection on the shapes of those before. @throws as
  /// LargeFamily::modes()
  void solve(double spin);
  /// The middle of the two neighbours between which the projection is off the most; nothing where that is `enough`.
  std::optional<double> worst_middle(double enough) const;
  /// Shapes of all in the coordinates of the projection, which no more are added to.
  void finish();

  bool knows(double spin) const { return at_.contains(spin); }
  const ProjectedFamily& projection() const { return *projection_; }
  /// Those solved; between them those of the projection, how far it may be off in their errors.
  ModesResult modes(double spin, const ModesOptions& options) const;

 private:
  struct At {
    ModesResult result;
    double off = 1;  // of frequencies of the projection before it, relative
    Index turn = 0;  // its place in the order of solving
  };
  using Place = std::map<double, At>::const_iterator;
  // What is known of a projection between two neighbours: how far it was off at the later one, without that one.
  static double off_between(Place a, Place b) { return a->second.turn > b->second.turn ? a->second.off : b->second.off; }

  const LargeFamily& family_;
  std::optional<Index> lowest_;
  ModesOptions asked_;
  std::optional<ProjectedFamily> projection_;
  std::map<double, At> at_;
};

}  // namespace gyromode
