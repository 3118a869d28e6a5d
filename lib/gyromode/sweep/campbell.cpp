#include "gyromode/sweep/campbell.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/team.h"
#include "gyromode/sweep/encounters.h"
#include "gyromode/sweep/excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace gyromode {

void require(const CampbellOptions& o) {
  if (o.spins.size() < 2) throw InvalidArgument("a diagram over the spin has two spins or more");
  if (!std::is_sorted(o.spins.begin(), o.spins.end()) || !std::isfinite(o.spins.back() - o.spins.front()) ||
      std::adjacent_find(o.spins.begin(), o.spins.end()) != o.spins.end())
    throw InvalidArgument("spins must be finite, each above the one before");
  if (!(o.below > 0)) throw InvalidArgument(fmt::format("frequencies below {}: a bound above 0 was expected", o.below));
  if (o.lowest && *o.lowest < 1) throw InvalidArgument("the lowest modes: at least one must be asked for");
  for (const double m : o.orders) {
    if (!(m >= 0) || !std::isfinite(m)) throw InvalidArgument(fmt::format("order {}: a multiple of the speed, 0 or more, was expected", m));
  }
}

namespace {

// Branches by frequency; of two that coincide the one that falls first.
std::vector<Index> in_order(const SpinTrack::Point& p) {
  std::vector<std::size_t> all(p.branch.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  for (std::size_t k = 1; k < all.size(); ++k) {
    const SampledMode &a = p.sample.modes[all[k - 1]], &b = p.sample.modes[all[k]];
    if (b.omega - a.omega <= 4 * (a.error + b.error) && a.slope && b.slope && *a.slope > *b.slope) std::swap(all[k - 1], all[k]);
  }
  std::vector<Index> branches;
  for (const std::size_t k : all) branches.push_back(p.branch[k]);
  return branches;
}

}  // namespace

bool Campbell::is_complete() const {
  return !interrupted &&
         std::all_of(coverage.begin(), coverage.end(), [](const Coverage& c) { return c.status == CoverageStatus::complete; });
}

Campbell campbell(const SpinSource& source, const CampbellOptions& o) {
  require(o);
  const lapack::BlasOnOneThread one;  // spins are solved side by side
  const SpinSampler sampler(source, {o.below, o.lowest}, o.spins.front(), o.spins.back());
  SpinTrack track(sampler, o.spins, o.progress);
  Campbell c;
  c.interrupted = track.interrupted();
  if (!c.interrupted) {
    o.progress.stage("encounters");
    c.encounters = encounters(track);
    o.progress.stage("excitations");
    for (const double order : o.orders) c.excitation.push_back(intersections(track, source, order));
  }
  // Branches in the order in which they appear; those seen between the spins only are left out.
  std::vector<Index> place(static_cast<std::size_t>(track.branches()), -1);
  for (const double spin : o.spins) {
    const auto found = track.points().find(spin);
    if (found == track.points().end()) break;
    for (const Index b : in_order(found->second)) {
      Index& p = place[static_cast<std::size_t>(b)];
      if (p >= 0) continue;
      p = static_cast<Index>(c.branches.size());
      c.branches.emplace_back();
    }
    c.spins.push_back(spin);
  }
  for (CampbellBranch& b : c.branches) b.modes.resize(c.spins.size());
  for (std::size_t s = 0; s < c.spins.size(); ++s) {
    const SpinTrack::Point& p = track.points().at(c.spins[s]);
    for (std::size_t k = 0; k < p.branch.size(); ++k) {
      SampledMode m = p.sample.modes[k];
      m.shape.resize(0);
      c.branches[static_cast<std::size_t>(place[static_cast<std::size_t>(p.branch[k])])].modes[s] = std::move(m);
    }
    c.coverage.push_back(p.sample.coverage);
    c.stability.push_back(p.sample.stability);
    double growth = 0;
    for (const UnstableMode& u : p.sample.unstable) growth = std::max(growth, u.growth_rate);
    c.growth_rate.push_back(growth);
  }
  const auto shown = [&](Index b) { return place[static_cast<std::size_t>(b)] >= 0; };
  std::erase_if(c.encounters, [&](const Encounter& e) { return !shown(e.branches[0]) || !shown(e.branches[1]); });
  for (Encounter& e : c.encounters) {
    for (Index& b : e.branches) b = place[static_cast<std::size_t>(b)];
  }
  for (Intersections& line : c.excitation) {
    std::erase_if(line.all, [&](const Intersection& x) { return !shown(x.branch); });
    for (Intersection& x : line.all) x.branch = place[static_cast<std::size_t>(x.branch)];
  }
  return c;
}

}  // namespace gyromode
