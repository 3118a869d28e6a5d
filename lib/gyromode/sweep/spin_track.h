#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/sweep/spin_sampler.h"

#include <map>
#include <vector>

namespace gyromode {

/// Modes of many spins, joined to branches. Within a block of a family the roots of one energy sign keep their order as
/// the spin changes, so that the k-th of one spin is the k-th of the next, but where the index balance says that roots
/// have come or gone: through zero, or to and from the complex plane (flutter). There the step is halved until every
/// root has one that it continues; roots that return to the axis continue the branches that left it. Steps in which
/// branches come near to each other otherwise than two by two, once, are halved too.
class SpinTrack {
 public:
  /// A spin with the branch of every mode of its sample.
  struct Point {
    SpinSample sample;
    std::vector<Index> branch;
    std::vector<Index> place;  // of every branch among the modes; −1, or past the end: none
  };

  /// Samples the spins, ascending, and joins them. `progress` is told "spins"; where it stops, the spins joined by then
  /// are kept (interrupted()).
  SpinTrack(const SpinSampler& sampler, const std::vector<double>& spins, const Progress& progress = {});

  const std::map<double, Point>& points() const { return points_; }
  bool interrupted() const { return interrupted_; }
  Index branches() const { return branches_; }
  /// The point at a spin between the first and the last; sampled where there is none yet.
  const Point& at(double spin);
  /// The mode of a branch at a point; null where it has none.
  static const SampledMode* mode(const Point& point, Index branch);

 private:
  // For every mode of b the mode of a that it continues, or −1.
  struct Joined {
    std::vector<Index> from;
    bool sure = true;
  };
  static Joined join(const SpinSample& a, const SpinSample& b);
  void extend(const Point& from, SpinSample sample, int halvings);
  static std::vector<Index> continued(const Point& from, const SpinSample& sample);
  const Point& keep(Point point);
  void resume(const Point& from, Point& to);
  void refine(double below, double above, int halvings);

  using Key = std::pair<Index, int>;  // block and energy sign
  static std::map<Key, std::vector<Index>> lists_of(const SpinSample& s);
  static bool is_understood(const SpinSample& a, const SpinSample& b);
  static bool may_meet_before_the_end(const Point& here, const Point& there);
  static bool may_meet_between_ends(const Point& a, const Point& b);

  // No step is halved where the work is spent, or was stopped: spins far beyond all frequencies of a model, say.
  bool may_halve() const { return halvings_left_ > 0 && !progress_.stopped(); }

  const SpinSampler& sampler_;
  Progress progress_;
  Index halvings_left_ = 0;
  std::map<double, Point> points_;
  Index branches_ = 0;
  std::map<Key, std::vector<Index>> fluttering_;  // branches that have left the axis
  bool interrupted_ = false;
};

}  // namespace gyromode
