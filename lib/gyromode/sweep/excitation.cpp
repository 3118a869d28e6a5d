#include "gyromode/sweep/excitation.h"

#include "gyromode/sweep/critical_speeds.h"
#include "gyromode/sweep/secant_bracket.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode {

namespace {

// Which branch a mode of shape X at Ω, with frequency ω there, belongs to: of those with that frequency the one of that
// shape.
std::optional<Index> branch_of(SpinTrack& track, double spin, double omega, const ComplexVector& shape) {
  constexpr double same = 1e-6;
  const SpinTrack::Point& p = track.at(spin);
  std::optional<Index> best;
  double likeness = 0;
  for (std::size_t k = 0; k < p.branch.size(); ++k) {
    const SampledMode& m = p.sample.modes[k];
    if (std::abs(m.omega - omega) > same * omega + 4 * m.error) continue;
    const double now = std::norm(m.shape.dot(shape)) / (m.shape.squaredNorm() * shape.squaredNorm());
    if (best && now <= likeness) continue;
    best = p.branch[k];
    likeness = now;
  }
  return best;
}

bool has_pencil(const SpinSource& source, double first) {
  return source.family && !source.projected && first >= 0 &&
         (source.family->gyroscopic.size() == 0 || source.family->gyroscopic.cwiseAbs().maxCoeff() == 0);
}

// Root of ω(Ω) − m|Ω| of a branch between two spins, by secants kept in the bracket.
Intersection refined(SpinTrack& track, Index branch, double order, double lo, double hi) {
  const auto height = [&](double spin) {
    const SampledMode* m = SpinTrack::mode(track.at(spin), branch);
    return m ? std::optional(m->omega - order * std::abs(spin)) : std::nullopt;
  };
  constexpr int most = 60;
  SecantBracket bracket(lo, *height(lo), hi, *height(hi));
  double t = lo;
  const auto error_at = [&](double spin) { return SpinTrack::mode(track.at(spin), branch)->error; };
  for (int step = 0; step < most; ++step) {
    const double next = bracket.next();
    if (!bracket.holds(next)) break;
    const auto f = height(next);
    if (!f) break;
    t = next;
    if (std::abs(*f) <= error_at(t) || bracket.width() <= 4 * epsilon * std::abs(t)) break;
    bracket.narrow(t, *f);
  }
  return {order, t, branch, order * std::abs(t), error_at(t), SpinTrack::mode(track.at(t), branch)->whirl};
}

Intersections by_pencil(SpinTrack& track, const SpinSource& source, double order) {
  CriticalOptions o;
  o.order = order;
  o.window = {track.points().begin()->first, std::nextafter(track.points().rbegin()->first, infinity)};
  const CriticalSpeeds found = critical_speeds(*source.family, o, source.places);
  Intersections r{order, {}, found.coverage};
  for (const CriticalSpeed& c : found.speeds) {
    const auto branch = branch_of(track, c.speed, order * c.speed, c.shape);
    if (branch) r.all.push_back({order, c.speed, *branch, order * c.speed, c.error_bound, c.whirl});
  }
  return r;
}

Intersections by_signs(SpinTrack& track, double order) {
  Intersections r{order, {}, {}};
  std::vector<double> spins;
  for (const auto& [spin, point] : track.points()) spins.push_back(spin);
  for (Index b = 0; b < track.branches(); ++b) {
    // The height of the branch over the line at every point: 0 where it is within its error, not a number where there
    // is none.
    std::vector<double> height{std::nan("")};
    for (const double spin : spins) {
      const SampledMode* m = SpinTrack::mode(track.at(spin), b);
      const double above = m ? m->omega - order * std::abs(spin) : std::nan("");
      height.push_back(m && std::abs(above) <= 4 * m->error ? 0 : above);
    }
    height.push_back(std::nan(""));
    for (std::size_t k = 0; k < spins.size(); ++k) {
      const double before = height[k], here = height[k + 1], after = height[k + 2];
      if (here == 0 && before != 0 && after != 0) {  // the line itself is no intersection
        const SampledMode* m = SpinTrack::mode(track.at(spins[k]), b);
        r.all.push_back({order, spins[k], b, m->omega, m->error, m->whirl});
      } else if (before * here < 0) {
        r.all.push_back(refined(track, b, order, spins[k - 1], spins[k]));
      }
    }
  }
  std::stable_sort(r.all.begin(), r.all.end(), [](const Intersection& a, const Intersection& b) { return a.spin < b.spin; });
  r.coverage.window = r.coverage.requested = {std::max(spins.front(), 0.0), spins.back()};
  r.coverage.found = static_cast<Index>(r.all.size());
  r.coverage.reason = "by the signs of ω − mΩ at the spins: an even number of intersections within a step is not seen";
  return r;
}

}  // namespace

Intersections intersections(SpinTrack& track, const SpinSource& source, double order) {
  if (order > 0 && has_pencil(source, track.points().begin()->first)) {
    try {
      return by_pencil(track, source, order);
    } catch (const NotApplicable&) {  // rigid-body motions without inertia against this order
    }
  }
  return by_signs(track, order);
}

}  // namespace gyromode
