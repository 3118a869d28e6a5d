#include "gyromode/sweep/large_family.h"

#include "gyromode/sweep/quadrature_axes.h"
#include "gyromode/sweep/solved_spins.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace gyromode {

namespace {

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

// At the spins asked for, and in the middle of those between which the projection does not serve.
std::shared_ptr<SolvedSpins> solved(const LargeFamily& family, const CampbellOptions& o) {
  constexpr double serves = 1e-6;
  constexpr std::size_t most = 3;  // times as many as were asked for
  auto all = std::make_shared<SolvedSpins>(family, o);
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
  constexpr std::size_t most_places = 400;
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
  const std::shared_ptr<const SolvedSpins> all = solved(family, options);
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
