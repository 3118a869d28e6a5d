#include "gyromode/sweep/spin_track.h"

#include "gyromode/base/error.h"
#include "gyromode/base/parallel.h"
#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace gyromode {

namespace {

constexpr int most_halvings = 24;     // of a step in which roots come or go
constexpr int most_for_slopes = 10;   // of those because branches do not lead where their slopes say
constexpr int most_refinements = 16;  // of a step in which branches may meet
constexpr int most_between_ends = 6;  // of those though no end has both: one root that goes through zero looks so too
constexpr double unresolved = 4;      // times the errors of two frequencies: a distance below is not known

// Whether roots came or went between two spins otherwise than through the upper end of the window.
bool same_balance(const SpinSample& a, const SpinSample& b) {
  const IndexBalance &x = a.balance, &y = b.balance;
  return x.closed && y.closed && x.negative == y.negative && x.zero == y.zero && x.quadruples == y.quadruples &&
         x.real_pairs == y.real_pairs && x.negative_energy == y.negative_energy;
}

// How far b is from where a leads to.
double mismatch(const SampledMode& a, const SampledMode& b, double step) {
  const double plain = std::abs(b.omega - a.omega);
  if (!a.slope || !b.slope) return plain;
  return std::min(plain, std::abs(b.omega - a.omega - step * (*a.slope + *b.slope) / 2));
}

// For every item of `to` the position in `from` that it continues, in their order, or −1: the least sum of mismatches,
// where an item of either list that has no partner costs `alone`. `ends`: only the first and the last items of a list
// are alone.
std::vector<Index> aligned(const std::vector<Index>& from, const std::vector<Index>& to, double alone, bool ends,
                           const std::function<double(Index, Index)>& mismatch_of) {
  const std::size_t p = from.size(), q = to.size();
  std::vector<std::vector<double>> sum(p + 1, std::vector<double>(q + 1, 0));
  const auto step = [&](std::size_t i, std::size_t k) { return mismatch_of(from[i - 1], to[k - 1]); };
  // Before the first pair and after the last one anything may be alone, in both lists; between them nothing may, if
  // `ends`.
  for (std::size_t i = 0; i <= p; ++i) {
    for (std::size_t k = 0; k <= q; ++k) {
      double& best = sum[i][k];
      best = alone * static_cast<double>(i + k);
      if (i > 0 && k > 0) best = std::min(best, sum[i - 1][k - 1] + step(i, k));
      if (!ends && i > 0) best = std::min(best, sum[i - 1][k] + alone);
      if (!ends && k > 0) best = std::min(best, sum[i][k - 1] + alone);
    }
  }
  std::size_t i = p, k = q;
  double least = infinity;
  for (std::size_t a = 0; a <= p; ++a) {
    for (std::size_t b = 0; b <= q; ++b) {
      const double all = sum[a][b] + alone * static_cast<double>(p - a + q - b);
      if (all > least || (all == least && a + b < i + k)) continue;
      least = all;
      i = a;
      k = b;
    }
  }
  std::vector<Index> partner(q, -1);
  while (i > 0 && k > 0 && sum[i][k] < alone * static_cast<double>(i + k)) {
    if (sum[i][k] == sum[i - 1][k - 1] + step(i, k)) {
      partner[--k] = static_cast<Index>(--i);
    } else if (!ends && sum[i][k] == sum[i - 1][k] + alone) {
      --i;
    } else {
      --k;
    }
  }
  return partner;
}

}  // namespace

std::map<SpinTrack::Key, std::vector<Index>> SpinTrack::lists_of(const SpinSample& s) {
  std::map<Key, std::vector<Index>> lists;
  for (std::size_t k = 0; k < s.modes.size(); ++k) lists[{s.modes[k].block, s.modes[k].energy_sign}].push_back(static_cast<Index>(k));
  return lists;
}

const SampledMode* SpinTrack::mode(const Point& point, Index branch) {
  const auto k = static_cast<std::size_t>(branch);
  if (k >= point.place.size() || point.place[k] < 0) return nullptr;
  return &point.sample.modes[static_cast<std::size_t>(point.place[k])];
}

SpinTrack::Joined SpinTrack::join(const SpinSample& a, const SpinSample& b) {
  Joined joined{std::vector<Index>(b.modes.size(), -1), true};
  const bool same = same_balance(a, b);
  const double step = b.spin - a.spin;
  auto before = lists_of(a);
  for (const auto& [key, to] : lists_of(b)) {
    const std::vector<Index>& from = before[key];
    if (same) {
      for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k) joined.from[static_cast<std::size_t>(to[k])] = from[k];
      continue;
    }
    if (from.empty()) continue;
    // Without flutter a root comes and goes at the ends of a list: through zero, or through the end of the window.
    const bool ends = a.balance.closed && b.balance.closed && a.balance.quadruples == b.balance.quadruples;
    constexpr double part_of_gaps = 0.25;
    const double last = std::max(a.modes[static_cast<std::size_t>(from.back())].omega, b.modes[static_cast<std::size_t>(to.back())].omega);
    const double alone = part_of_gaps * last / static_cast<double>(std::max(from.size(), to.size()));
    const std::vector<Index> partner = aligned(from, to, alone, ends, [&](Index x, Index y) {
      return mismatch(a.modes[static_cast<std::size_t>(x)], b.modes[static_cast<std::size_t>(y)], step);
    });
    for (std::size_t k = 0; k < to.size(); ++k) {
      if (partner[k] >= 0) joined.from[static_cast<std::size_t>(to[k])] = from[static_cast<std::size_t>(partner[k])];
    }
    // Sure where every root moves by much less than what is between it and the others: what veers is not torn apart.
    constexpr double part = 0.25;
    for (std::size_t k = 0; k < to.size(); ++k) {
      const SampledMode& m = b.modes[static_cast<std::size_t>(to[k])];
      const Index source = joined.from[static_cast<std::size_t>(to[k])];
      if (source < 0) continue;
      const double before_it = a.modes[static_cast<std::size_t>(source)].omega, moved = std::abs(m.omega - before_it);
      for (const Index other : from) {
        if (other != source && !(moved < part * std::abs(a.modes[static_cast<std::size_t>(other)].omega - before_it))) joined.sure = false;
      }
      for (const Index other : to) {
        if (other != to[k] && !(moved < part * std::abs(b.modes[static_cast<std::size_t>(other)].omega - m.omega))) joined.sure = false;
      }
    }
  }
  return joined;
}

// Branches that leave the axis wait for roots of their block and sign that return to it.
void SpinTrack::resume(const Point& from, Point& to) {
  const Index left = to.sample.balance.quadruples - from.sample.balance.quadruples;
  if (left > 0) {
    for (std::size_t k = 0; k < from.branch.size(); ++k) {
      if (std::find(to.branch.begin(), to.branch.end(), from.branch[k]) == to.branch.end())
        fluttering_[{from.sample.modes[k].block, from.sample.modes[k].energy_sign}].push_back(from.branch[k]);
    }
  } else if (left < 0) {
    for (std::size_t k = 0; k < to.branch.size(); ++k) {
      auto& waiting = fluttering_[{to.sample.modes[k].block, to.sample.modes[k].energy_sign}];
      if (to.branch[k] >= 0 || waiting.empty()) continue;
      to.branch[k] = waiting.back();
      waiting.pop_back();
    }
  }
}

// The branch of every mode of `sample` that continues one of `from`; −1 of the others.
std::vector<Index> SpinTrack::continued(const Point& from, const SpinSample& sample) {
  std::vector<Index> all;
  for (const Index k : join(from.sample, sample).from) all.push_back(k < 0 ? -1 : from.branch[static_cast<std::size_t>(k)]);
  return all;
}

// Modes without a branch begin one.
const SpinTrack::Point& SpinTrack::keep(Point p) {
  for (Index& b : p.branch) {
    if (b < 0) b = branches_++;
  }
  p.place.assign(static_cast<std::size_t>(branches_), -1);
  for (std::size_t k = 0; k < p.branch.size(); ++k) p.place[static_cast<std::size_t>(p.branch[k])] = static_cast<Index>(k);
  const double spin = p.sample.spin;
  return points_.insert_or_assign(spin, std::move(p)).first->second;
}

void SpinTrack::extend(const Point& from, SpinSample sample, int halvings) {
  const Joined joined = join(from.sample, sample);
  const double middle = 0.5 * (from.sample.spin + sample.spin);
  const bool understood = is_understood(from.sample, sample) || halvings <= most_halvings - most_for_slopes;
  if ((joined.sure && understood) || halvings == 0 || !may_halve() || middle == from.sample.spin || middle == sample.spin) {
    Point p{std::move(sample), {}, {}};
    p.branch = continued(from, p.sample);
    resume(from, p);
    keep(std::move(p));
    return;
  }
  --halvings_left_;
  extend(from, sampler_.at(middle), halvings - 1);
  extend(points_.at(middle), std::move(sample), halvings - 1);
}

SpinTrack::SpinTrack(const SpinSampler& sampler, const std::vector<double>& spins, const Progress& progress)
    : sampler_(sampler), progress_(progress), halvings_left_(1000 + 100 * static_cast<Index>(spins.size())) {
  std::vector<std::optional<SpinSample>> samples(spins.size());
  const bool whole = for_each_in_parallel(
      static_cast<Index>(spins.size()),
      [&](Index k) { samples[static_cast<std::size_t>(k)] = sampler.at(spins[static_cast<std::size_t>(k)]); },
      [&](Index done) {
        progress.report("spins", done, static_cast<Index>(spins.size()));
        return !progress.stopped();
      });
  interrupted_ = !whole;
  const Point* last = nullptr;
  for (std::optional<SpinSample>& s : samples) {
    if (!s) break;
    const double spin = s->spin;
    if (!last)
      keep({*s, std::vector<Index>(s->modes.size(), -1), {}});
    else
      extend(*last, std::move(*s), most_halvings);
    last = &points_.at(spin);
  }
  if (!last) throw Interrupted();
  std::vector<double> joined;
  for (const auto& [spin, point] : points_) joined.push_back(spin);
  for (std::size_t k = 0; k + 1 < joined.size(); ++k) refine(joined[k], joined[k + 1], most_refinements);
}

// Whether every branch leads by its slopes to where it is next, or two neighbours of a list to each other's places.
bool SpinTrack::is_understood(const SpinSample& a, const SpinSample& b) {
  if (!same_balance(a, b)) return true;  // settled when they were joined
  constexpr double part = 0.1;           // of the distance to the next root
  const double step = b.spin - a.spin;
  auto after = lists_of(b);
  for (const auto& [key, from] : lists_of(a)) {
    const std::vector<Index>& to = after[key];
    const std::vector<Index>& list = from;  // structured bindings are not captured
    const std::size_t n = std::min(from.size(), to.size());
    const auto mode_of = [](const SpinSample& s, const std::vector<Index>& among, std::size_t k) -> const SampledMode& {
      return s.modes[static_cast<std::size_t>(among[k])];
    };
    const auto leads = [&](std::size_t i, std::size_t k) {
      const SampledMode &x = mode_of(a, list, i), &y = mode_of(b, to, k);
      if (!x.slope || !y.slope) return true;
      double room = 2 * std::min(x.omega, y.omega);  // to the mirror image, −ω
      for (std::size_t l = 0; l < n; ++l) {
        if (l != i) room = std::min(room, std::abs(mode_of(a, list, l).omega - x.omega));
        if (l != k) room = std::min(room, std::abs(mode_of(b, to, l).omega - y.omega));
      }
      return std::abs(y.omega - x.omega - step * (*x.slope + *y.slope) / 2) <= part * room + unresolved * (x.error + y.error);
    };
    for (std::size_t k = 0; k < n; ++k) {
      if (leads(k, k)) continue;
      if (k + 1 < n && leads(k, k + 1) && leads(k + 1, k)) {
        ++k;
        continue;
      }
      return false;
    }
  }
  return true;
}

// Whether a branch that is at one end of a step only might meet another one of that end before it is gone, as its slope
// goes: four times the step covers what ends in a square root (ω → 0, flutter).
bool SpinTrack::may_meet_before_the_end(const Point& here, const Point& there) {
  constexpr double reach = 4;
  const double step = there.sample.spin - here.sample.spin;
  for (std::size_t i = 0; i < here.branch.size(); ++i) {
    const SampledMode& leaving = here.sample.modes[i];
    if (mode(there, here.branch[i]) || !leaving.slope) continue;
    for (std::size_t k = 0; k < here.branch.size(); ++k) {
      const SampledMode& other = here.sample.modes[k];
      if (k == i || !other.slope || (other.block == leaving.block && other.energy_sign == leaving.energy_sign)) continue;
      const double d = leaving.omega - other.omega;
      if (d * (d + reach * step * (*leaving.slope - *other.slope)) < 0) return true;
    }
  }
  return false;
}

// Whether a branch goes to zero in a step and another comes from there, so that they may meet though no end of the step
// has both.
bool SpinTrack::may_meet_between_ends(const Point& a, const Point& b) {
  constexpr double reach = 4;
  const double step = b.sample.spin - a.sample.spin;
  const auto at_zero = [&](const Point& here, const Point& there, double sign) {
    for (std::size_t i = 0; i < here.branch.size(); ++i) {
      const SampledMode& m = here.sample.modes[i];
      if (!mode(there, here.branch[i]) && m.slope && m.omega + sign * reach * step * *m.slope < 0) return true;
    }
    return false;
  };
  return at_zero(a, b, 1) && at_zero(b, a, -1);
}

void SpinTrack::refine(double below, double above, int halvings) {
  const double middle = 0.5 * (below + above);
  if (halvings == 0 || !may_halve() || middle == below || middle == above) return;
  const Point &a = points_.at(below), &b = points_.at(above);
  const bool meet = may_meet_before_the_end(a, b) || may_meet_before_the_end(b, a) ||
                    (halvings > most_refinements - most_between_ends && may_meet_between_ends(a, b));
  if (is_understood(a.sample, b.sample) && !meet) return;
  --halvings_left_;
  at(middle);
  refine(below, middle, halvings - 1);
  refine(middle, above, halvings - 1);
}

// A point between two others continues the one below where nothing came or went, else the one above; what it does not
// find there (it has come into the window) the other.
const SpinTrack::Point& SpinTrack::at(double spin) {
  const auto next = points_.lower_bound(spin);
  if (next->first == spin) return next->second;
  const Point &above = next->second, &below = std::prev(next)->second;
  SpinSample sample = sampler_.at(spin);
  const bool like_below = same_balance(below.sample, sample) || !same_balance(sample, above.sample);
  const Point &like = like_below ? below : above, &unlike = like_below ? above : below;
  Point p{std::move(sample), {}, {}};
  p.branch = continued(like, p.sample);
  const std::vector<Index> otherwise = continued(unlike, p.sample);
  for (std::size_t k = 0; k < p.branch.size(); ++k) {
    if (p.branch[k] < 0 && std::find(p.branch.begin(), p.branch.end(), otherwise[k]) == p.branch.end()) p.branch[k] = otherwise[k];
  }
  return keep(std::move(p));
}

}  // namespace gyromode
