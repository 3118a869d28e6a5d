#include "gyromode/sweep/encounters.h"

#include "gyromode/base/rounding.h"
#include "gyromode/sweep/secant_bracket.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gyromode {

namespace {

constexpr int most_steps = 80;
constexpr int most_looks = 20;
constexpr double too_near = 4;  // times the errors of both frequencies: a gap below is not known

// Two branches at one spin: a below b where the search began.
struct Pair {
  const SpinTrack::Point* point = nullptr;
  const SampledMode* a = nullptr;
  const SampledMode* b = nullptr;

  double spin() const { return point->sample.spin; }
  bool both() const { return a && b; }
  double distance() const { return b->omega - a->omega; }
  double error() const { return a->error + b->error; }
  bool apart() const { return std::abs(distance()) > too_near * error(); }
  bool sloped() const { return a->slope && b->slope; }
  double slope() const { return *b->slope - *a->slope; }
  double mean() const { return 0.5 * (a->omega + b->omega); }
  /// Of the square of the distance, half the derivative: smooth through a veering.
  double square_slope() const { return distance() * slope(); }
};

// Whether no other root of their block and sign is between them.
bool neighbours(const Pair& p) {
  return std::none_of(p.point->sample.modes.begin(), p.point->sample.modes.end(), [&](const SampledMode& m) {
    return &m != p.a && &m != p.b && m.block == p.a->block && m.energy_sign == p.a->energy_sign && m.omega >= p.a->omega &&
           m.omega <= p.b->omega;
  });
}

class Search {
 public:
  Search(SpinTrack& track, std::vector<Encounter>& all)
      : track_(track), all_(all), first_(track.points().begin()->first), last_(track.points().rbegin()->first) {}

  Pair at(double spin, Index i, Index k) {
    const SpinTrack::Point& p = track_.at(spin);
    return {&p, SpinTrack::mode(p, i), SpinTrack::mode(p, k)};
  }
  void crossing(Index i, Index k, const Pair& lo, const Pair& hi);
  void touching(Index i, Index k, const Pair& lo, const Pair& hi, int depth);
  void veering(Index i, Index k, Pair lo, Pair hi);
  void opposite_signs(Index i, Index k, Pair lo, Pair hi);
  void flutter(Index i, Index k, const Pair& before, const Pair& off, const Pair& after);
  double onset(Index i, Index k, Pair on, Pair off);

 private:
  void add(EncounterKind kind, Index i, Index k, const Pair& at, double gap) {
    all_.push_back({kind, at.spin(), at.mean(), {i, k}, gap, at.error(), std::nullopt});
  }

  SpinTrack& track_;
  std::vector<Encounter>& all_;
  double first_, last_;
};

// The square of the distance, or of the growth of the roots that have met: smooth through the collision.
double signed_square(const Pair& p, double about) {
  if (p.both()) return p.distance() * p.distance();
  double growth = 0, best = infinity;
  for (const UnstableMode& u : p.point->sample.unstable) {
    if (!u.flutter() || std::abs(u.omega - about) >= best) continue;
    best = std::abs(u.omega - about);
    growth = u.growth_rate;
  }
  return -4 * growth * growth;
}

// Root of the distance by secants.
void Search::crossing(Index i, Index k, const Pair& lo, const Pair& hi) {
  SecantBracket bracket(lo.spin(), lo.distance(), hi.spin(), hi.distance());
  Pair best = std::abs(lo.distance()) < std::abs(hi.distance()) ? lo : hi;
  for (int step = 0; step < most_steps; ++step) {
    const double t = bracket.next();
    if (!bracket.holds(t) || bracket.is_closed()) break;
    const Pair now = at(t, i, k);
    if (!now.both()) break;
    const double f = now.distance();
    if (std::abs(f) <= std::abs(best.distance())) best = now;
    if (std::abs(f) <= now.error()) break;
    bracket.narrow(t, f);
  }
  add(EncounterKind::crossing, i, k, best, 0);
}

// Branches of two blocks that approach each other and part again: twice through each other, or not at all.
void Search::touching(Index i, Index k, const Pair& lo, const Pair& hi, int depth) {
  if (depth == 0 || !lo.sloped() || !hi.sloped()) return;
  const double sign = lo.distance() < 0 ? -1 : 1;
  if (!(sign * lo.slope() < 0 && sign * hi.slope() > 0)) return;
  // The tangents at both ends meet below the smallest distance where it is convex, and near it where a branch veers.
  constexpr double margin = 0.5;
  const double d_lo = sign * lo.distance(), s_lo = sign * lo.slope(), d_hi = sign * hi.distance(), s_hi = sign * hi.slope();
  const double x = (d_hi - d_lo - s_hi * (hi.spin() - lo.spin())) / (s_lo - s_hi);
  const bool inside = x > 0 && x < hi.spin() - lo.spin();
  if (inside && d_lo + s_lo * x > margin * std::min(d_lo, d_hi)) return;
  const double t = inside ? lo.spin() + x : 0.5 * (lo.spin() + hi.spin());
  if (!(t > lo.spin() && t < hi.spin())) return;
  const Pair now = at(t, i, k);
  if (!now.both()) return;
  if (!now.apart()) {
    add(EncounterKind::ambiguous, i, k, now, std::abs(now.distance()));
  } else if (sign * now.distance() < 0) {
    crossing(i, k, lo, now);
    crossing(i, k, now, hi);
  } else {
    touching(i, k, lo, now, depth - 1);
    touching(i, k, now, hi, depth - 1);
  }
}

// Root of the derivative of the square of the distance.
void Search::veering(Index i, Index k, Pair lo, Pair hi) {
  SecantBracket bracket(lo.spin(), lo.square_slope(), hi.spin(), hi.square_slope());
  Pair best = lo.distance() < hi.distance() ? lo : hi;
  double curvature = (hi.square_slope() - lo.square_slope()) / (hi.spin() - lo.spin());
  for (int step = 0; step < most_steps; ++step) {
    const double t = bracket.next();
    if (!bracket.holds(t)) break;
    const Pair now = at(t, i, k);
    if (!now.both() || !now.sloped()) break;
    const double f = now.square_slope();
    curvature = std::abs(t - lo.spin()) > std::abs(t - hi.spin()) ? (f - lo.square_slope()) / (t - lo.spin())
                                                                  : (hi.square_slope() - f) / (hi.spin() - t);
    const double before = best.distance();
    if (now.distance() <= best.distance()) best = now;
    const double width = best.distance() / std::sqrt(std::max(curvature, 1e-300));
    if (std::abs(f) <= 1e-6 * width * curvature || (now.distance() == before && step > 4)) break;
    (bracket.narrow(t, f) ? lo : hi) = now;
  }
  if (!neighbours(best)) return;
  const double width = best.distance() / std::sqrt(std::max(curvature, 1e-300));
  if (!(width <= best.spin() - first_ && width <= last_ - best.spin())) return;
  add(best.apart() ? EncounterKind::veering : EncounterKind::ambiguous, i, k, best, best.distance());
}

// The spin between a pair on the axis and one off it at which it leaves.
double Search::onset(Index i, Index k, Pair on, Pair off) {
  const double about = on.mean();
  double f_on = signed_square(on, about), f_off = signed_square(off, about);
  for (int step = 0; step < most_steps; ++step) {
    double t = (on.spin() * f_off - off.spin() * f_on) / (f_off - f_on);
    const double width = std::abs(off.spin() - on.spin());
    if (step % 3 == 2 || !std::isfinite(t) || std::abs(t - on.spin()) >= width || std::abs(t - off.spin()) >= width)
      t = 0.5 * (on.spin() + off.spin());
    if (t == on.spin() || t == off.spin() || width <= 1e-12 * std::max(std::abs(on.spin()), std::abs(off.spin()))) break;
    const Pair now = at(t, i, k);
    (now.both() ? on : off) = now;
    (now.both() ? f_on : f_off) = signed_square(now, about);
  }
  return 0.5 * (on.spin() + off.spin());
}

void Search::flutter(Index i, Index k, const Pair& before, const Pair& off, const Pair& after) {
  Encounter e{EncounterKind::collision, 0, 0, {i, k}, 0, before.both() ? before.error() : after.error(), std::nullopt};
  const double from = before.both() ? onset(i, k, before, off) : off.spin(), to = after.both() ? onset(i, k, after, off) : off.spin();
  const Pair& seen = before.both() ? before : after;
  e.spin = before.both() ? from : to;
  e.omega = seen.mean();
  for (const UnstableMode& u : off.point->sample.unstable) {
    if (u.flutter() && std::abs(u.omega - seen.mean()) < 0.1 * seen.mean()) e.omega = u.omega;
  }
  e.flutter = std::array{from, to};
  all_.push_back(e);
}

// Both on the axis at both ends, in one order or in two: did they meet between?
void Search::opposite_signs(Index i, Index k, Pair lo, Pair hi) {
  const bool swapped = (lo.distance() < 0) != (hi.distance() < 0);
  if (!swapped && !(lo.sloped() && hi.sloped() && lo.square_slope() < 0 && hi.square_slope() > 0)) return;
  Pair best = std::abs(lo.distance()) < std::abs(hi.distance()) ? lo : hi;
  for (int step = 0; step < most_steps; ++step) {
    const double f_lo = swapped ? lo.distance() : lo.square_slope(), f_hi = swapped ? hi.distance() : hi.square_slope();
    double t = (lo.spin() * f_hi - hi.spin() * f_lo) / (f_hi - f_lo);
    if (step % 3 == 2) t = 0.5 * (lo.spin() + hi.spin());
    if (!(t > lo.spin() && t < hi.spin()) || hi.spin() - lo.spin() <= 1e-13 * std::max(std::abs(lo.spin()), std::abs(hi.spin()))) break;
    const Pair now = at(t, i, k);
    if (!now.both()) {
      if (now.point->sample.balance.quadruples > lo.point->sample.balance.quadruples) flutter(i, k, lo, now, hi);
      return;
    }
    if (std::abs(now.distance()) < std::abs(best.distance())) best = now;
    if (!now.apart()) break;
    if (!swapped && !now.sloped()) return;
    ((swapped ? (now.distance() < 0) == (lo.distance() < 0) : now.square_slope() < 0) ? lo : hi) = now;
  }
  if (swapped || !best.apart()) add(EncounterKind::ambiguous, i, k, best, std::abs(best.distance()));
}

}  // namespace

std::string_view to_string(EncounterKind kind) {
  switch (kind) {
    case EncounterKind::crossing: return "crossing";
    case EncounterKind::veering: return "veering";
    case EncounterKind::collision: return "collision";
    default: return "ambiguous";
  }
}

namespace {

// What a pair does over all points of the track: `one_block` those of one block of the family, or only others.
void walk(Search& search, const std::vector<double>& spins, Index i, Index k, bool one_block) {
  Pair last, seen, off;  // last place where they were apart; last seen; first place off the axis after that
  for (const double spin : spins) {
    const Pair now = search.at(spin, i, k);
    if (!now.both()) {
      const bool fluttering =
          !now.a && !now.b && seen.both() && now.point->sample.balance.quadruples > seen.point->sample.balance.quadruples;
      if (fluttering && !off.point) off = now;
      if (!fluttering) seen = last = off = {};
      continue;
    }
    if ((now.a->block == now.b->block) != one_block) return;
    const bool one_sign = now.a->energy_sign == now.b->energy_sign;
    if (off.point) {
      if (i < k && one_block && !one_sign) search.flutter(i, k, seen, off, now);
      off = {};
    } else if (last.both() && now.apart() && last.distance() > 0) {  // each pair is seen in both orders
      const bool swapped = now.distance() < 0;
      if (!one_block && swapped)
        search.crossing(i, k, last, now);
      else if (!one_block)
        search.touching(i, k, last, now, most_looks);
      else if (!one_sign)
        search.opposite_signs(i, k, last, now);
      else if (!swapped && last.sloped() && now.sloped() && last.slope() < 0 && now.slope() > 0 && (neighbours(last) || neighbours(now)))
        search.veering(i, k, last, now);
    }
    seen = now;
    if (now.apart()) last = now;
  }
  // Off the axis until the end of the range.
  if (off.point && i < k && one_block && seen.a->energy_sign != seen.b->energy_sign) search.flutter(i, k, seen, off, {});
}

}  // namespace

namespace {

// Two branches that are at one spin together, and the places of the first and the last of these among the spins.
using Together = std::map<std::pair<Index, Index>, std::pair<std::size_t, std::size_t>>;

Together together(const SpinTrack& track) {
  Together all;
  std::size_t place = 0;
  for (const auto& [spin, point] : track.points()) {
    for (const Index i : point.branch) {
      for (const Index k : point.branch) {
        if (i != k) all.try_emplace({i, k}, place, place).first->second.second = place;
      }
    }
    ++place;
  }
  return all;
}

}  // namespace

// Those of one block first: where branches veer is a point of the track then, and between the points they are smooth.
std::vector<Encounter> encounters(SpinTrack& track) {
  std::vector<Encounter> all;
  Search search(track, all);
  for (const bool one_block : {true, false}) {
    std::vector<double> spins;
    for (const auto& [spin, point] : track.points()) spins.push_back(spin);
    for (const auto& [pair, where] : together(track)) {
      // One spin more on either side: there the pair may be off the axis.
      const std::size_t from = where.first > 0 ? where.first - 1 : 0, past = std::min(where.second + 2, spins.size());
      walk(search, {spins.begin() + static_cast<std::ptrdiff_t>(from), spins.begin() + static_cast<std::ptrdiff_t>(past)}, pair.first,
           pair.second, one_block);
    }
  }
  std::stable_sort(all.begin(), all.end(), [](const Encounter& a, const Encounter& b) { return a.spin < b.spin; });
  return all;
}

}  // namespace gyromode
