#include "gyromode/sweep/large_family.h"

#include "gyromode/sweep/projected_family.h"
#include "gyromode/sweep/quadrature_axes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

namespace gyromode {

namespace {

constexpr Index more_modes = 4;  // beyond those asked for, so that the space serves up to the last
constexpr std::size_t most_places = 400;

// The spins by halves: first the ends, then the middle, then the middles of these.
std::vector<std::size_t> by_halves(std::size_t count) {
  std::vector<std::size_t> all{0, count - 1};
  std::vector<std::pair<std::size_t, std::size_t>> gaps{{0, count - 1}};
  while (!gaps.empty()) {
    std::vector<std::pair<std::size_t, std::size_t>> next;
    for (const auto& [a, b] : gaps) {
      if (b - a < 2) continue;
      const std::size_t middle = (a + b) / 2;
      all.push_back(middle);
      next.insert(next.end(), {{a, middle}, {middle, b}});
    }
    gaps = std::move(next);
  }
  return all;
}

bool vibrates(const Mode& m) { return m.kind != ModeKind::rigid_body && m.omega > 0; }

// The lowest so many of a complete result, and what coincides with the last of them.
void keep_lowest(Index lowest, ModesResult& r) {
  constexpr double apart = 1e-9;
  std::size_t kept = 0;
  for (Index vibrations = 0; kept < r.modes.size(); ++kept) {
    if (!vibrates(r.modes[kept])) continue;
    if (vibrations >= lowest && r.modes[kept].omega - r.modes[kept - 1].omega > apart * r.modes[kept].omega) break;
    ++vibrations;
  }
  if (kept == r.modes.size() || r.coverage.status != CoverageStatus::complete) return;
  r.coverage.window.b = 0.5 * (r.modes[kept - 1].omega + r.modes[kept].omega);
  r.modes.resize(kept);
  r.coverage.found = 0;
  for (const Mode& m : r.modes) r.coverage.found += m.multiplicity;
  r.coverage.counted = r.coverage.found;
}

ComplexMatrix shapes_of(const ModesResult& r) {
  ComplexMatrix all(r.modes.empty() ? 0 : r.modes.front().shape.size(), static_cast<Index>(r.modes.size()));
  for (std::size_t k = 0; k < r.modes.size(); ++k) all.col(static_cast<Index>(k)) = r.modes[k].shape;
  return all;
}

// The largest distance, relative, of a frequency found to the nearest of the projection.
double departure(const ModesResult& found, const ModesResult& projected) {
  double most = 0;
  for (const Mode& m : found.modes) {
    if (!vibrates(m)) continue;
    double nearest = 1;
    for (const Mode& p : projected.modes) nearest = std::min(nearest, std::abs(p.omega - m.omega) / m.omega);
    most = std::max(most, nearest);
  }
  return most;
}

double highest_of(const ModesResult& r) { return r.modes.empty() || !(r.modes.back().omega > 0) ? 1 : r.modes.back().omega; }

// The family at the spins solved, and its projection.
class Solved {
 public:
  Solved(const LargeFamily& family, const CampbellOptions& o) : family_(family), lowest_(o.lowest) {
    asked_.shapes = true;
    asked_.window.b = o.below;
    if (o.lowest) asked_.lowest = *o.lowest + more_modes;
    asked_.progress.stop = o.progress.stop;
  }

  /// Solves one more, and tells how far the projection on the shapes of those before is off there.
  void solve(double spin);
  /// The middle of the two neighbours between which the projection is off the most; nothing where that is `enough`.
  std::optional<double> worst_middle(double enough) const;
  /// Shapes of all in the coordinates of the projection, which no more are added to.
  void finish();

  bool knows(double spin) const { return at_.contains(spin); }
  const ProjectedFamily& projection() const { return *projection_; }
  ModesResult modes(double spin, const ModesOptions& options) const;

 private:
  struct At {
    ModesResult result;
    double off = 1;  // of frequencies of the projection before it, relative
    Index turn = 0;  // the how manieth it was
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

void Solved::solve(double spin) {
  At now;
  now.result = family_.modes(spin, asked_);
  if (asked_.progress.stopped()) return;
  now.turn = static_cast<Index>(at_.size());
  if (!projection_) projection_.emplace(family_, highest_of(now.result));
  if (at_.size() >= 2 && projection_->order() > 0) {
    ModesOptions same = asked_;
    same.shapes = false;
    same.progress = {};
    same.method = Method::general;
    now.off = departure(now.result, find_modes(projection_->family().at(spin), same));
  }
  if (!now.result.modes.empty()) projection_->add(shapes_of(now.result));
  if (lowest_) keep_lowest(*lowest_, now.result);
  at_.emplace(spin, std::move(now));
}

std::optional<double> Solved::worst_middle(double enough) const {
  std::optional<double> middle;
  for (auto a = at_.begin(); a != at_.end() && std::next(a) != at_.end(); ++a) {
    const auto b = std::next(a);
    if (off_between(a, b) <= enough) continue;
    enough = off_between(a, b);
    middle = 0.5 * (a->first + b->first);
  }
  return middle;
}

void Solved::finish() {
  for (auto& [spin, at] : at_) {
    if (at.result.modes.empty()) continue;
    const ComplexMatrix y = projection_->coordinates(shapes_of(at.result));
    for (std::size_t k = 0; k < at.result.modes.size(); ++k) at.result.modes[k].shape = y.col(static_cast<Index>(k));
  }
}

ModesResult Solved::modes(double spin, const ModesOptions& options) const {
  const auto above = at_.lower_bound(spin);
  if (above != at_.end() && above->first == spin) return above->second.result;
  if (projection_->order() == 0) return at_.begin()->second.result;  // no modes at any spin
  ModesOptions o = options;
  o.method = Method::general;  // a hidden symmetry takes longer to find than all modes
  ModesResult r = find_modes(projection_->family().at(spin), o);
  const double off = above == at_.end() || above == at_.begin() ? 1 : off_between(std::prev(above), above);
  for (Mode& m : r.modes) m.error_bound += off * m.omega;
  return r;
}

// At the spins asked for, and in the middle of those between which the projection does not serve.
std::shared_ptr<Solved> solved(const LargeFamily& family, const CampbellOptions& o) {
  constexpr double serves = 1e-6;
  constexpr std::size_t most = 3;  // times as many as were asked for
  auto all = std::make_shared<Solved>(family, o);
  const std::size_t count = o.spins.size();
  std::size_t done = 0;
  for (const std::size_t k : by_halves(count)) {
    o.progress.report("spins", static_cast<Index>(done++), static_cast<Index>(count));
    if (o.progress.stopped()) break;
    all->solve(o.spins[k]);
  }
  for (; done < most * count && !o.progress.stopped(); ++done) {
    const auto middle = all->worst_middle(serves);
    if (!middle) break;
    o.progress.report("spins between these", static_cast<Index>(done - count), 0);
    all->solve(*middle);
  }
  all->finish();
  return all;
}

// Some of the places, evenly, and their rows of the basis.
void add_places(const LargeFamily& family, const ProjectedFamily& projection, SpinSource& to) {
  const std::size_t step = family.places.size() / most_places + 1;
  std::vector<Index> rows;
  for (std::size_t k = 0; k < family.places.size(); k += step) {
    OrbitCoordinates place = family.places[k];
    const auto first = static_cast<Index>(rows.size());
    rows.insert(rows.end(), {place.x, place.y});
    place.x = first;
    place.y = first + 1;
    to.places.push_back(std::move(place));
  }
  to.seen = [basis = projection.rows(rows)](const ComplexVector& y) -> ComplexVector {
    return (basis * y.real()).cast<Complex>() + imaginary_unit * (basis * y.imag()).cast<Complex>();
  };
}

}  // namespace

Campbell campbell(const LargeFamily& family, const CampbellOptions& options) {
  require(options);
  const std::shared_ptr<const Solved> all = solved(family, options);
  CampbellOptions rest = options;  // up to the first that was not reached
  const auto missing = std::find_if(rest.spins.begin(), rest.spins.end(), [&](double s) { return !all->knows(s); });
  rest.spins.erase(missing, rest.spins.end());
  Campbell c;
  if (rest.spins.size() >= 2) {
    SpinSource source;
    if (all->projection().order() > 0) source.family = std::make_shared<const SpinFamily>(all->projection().family());
    source.projected = true;
    source.modes = [all](double spin, const ModesOptions& o) { return all->modes(spin, o); };
    add_places(family, all->projection(), source);
    c = campbell(source, rest);
  }
  c.interrupted = c.interrupted || rest.spins.size() < options.spins.size();
  return c;
}

}  // namespace gyromode
