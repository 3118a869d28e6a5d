#include "gyromode/models/unbalance.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gyromode {

namespace {

// Where a mass is: the station, and how far beyond it.
struct Place {
  const Station* station;
  double beyond = 0;
};

// x = U cos(rΩt + φ), y = U sin(rΩt + φ), as the real parts of f e^{jrΩt}.
std::array<Complex, 2> components(const Unbalance& u) {
  const Complex x = u.product * std::polar(1.0, u.phase);
  return {x, Complex(0, -1) * x};
}

const Station& station_numbered(const Rotor& r, std::string_view spool, std::int64_t which, const std::string& place) {
  std::int64_t count = 0;
  for (const Station& s : r.stations()) {
    if (r.spools()[s.spool].name == spool && ++count == which) return s;
  }
  if (count == 0)
    throw InvalidArgument(r.spools().size() == 1
                              ? fmt::format("unbalance '{}': the rotor has one shaft, whose stations are station1, station2, …", place)
                              : fmt::format("unbalance '{}': stations of a rotor of several spools are named with them: {}.station1", place,
                                            r.spools().front().name));
  throw InvalidArgument(fmt::format("unbalance '{}': there are stations 1 to {}", place, count));
}

template <class Part>
const Part& numbered(const std::vector<Part>& parts, std::int64_t which, const std::string& place) {
  if (which < 1) throw InvalidArgument(fmt::format("unbalance '{}': a number from 1 was expected at the end, as in disk1", place));
  if (which <= static_cast<std::int64_t>(parts.size())) return parts[static_cast<std::size_t>(which - 1)];
  throw InvalidArgument(parts.empty() ? fmt::format("unbalance '{}': the rotor has none of these", place)
                                      : fmt::format("unbalance '{}': there are 1 to {} of these", place, parts.size()));
}

Place place_of(const Rotor& r, const std::string& place) {
  const std::size_t digits = place.find_last_not_of("0123456789") + 1, point = place.rfind('.', digits);
  const std::int64_t which = whole_number(place.substr(digits)).value_or(0);
  const std::string spool = point == std::string::npos ? "" : place.substr(0, point),
                    kind = place.substr(spool.empty() ? 0 : point + 1, digits - (spool.empty() ? 0 : point + 1));
  const auto at = [&](const auto& part) { return Place{&r.station_at(r.spool_named(part.spool), part.position)}; };
  if (kind == "station") return {&station_numbered(r, spool, which, place)};
  if (spool.empty() && (kind == "disk" || kind == "disc")) {
    const Disc& d = numbered(r.parts().discs, which, place);
    return {at(d).station, d.offset};
  }
  if (spool.empty() && kind == "point_mass") return at(numbered(r.parts().point_masses, which, place));
  if (spool.empty() && kind == "bearing") return at(numbered(r.parts().bearings, which, place));
  constexpr std::array<std::string_view, 4> kinds{"disk", "point_mass", "bearing", "station"};
  throw InvalidArgument(fmt::format("unbalance '{}': disk1, point_mass1, bearing1 or station1 was expected, counted from 1{}", place,
                                    suggestion(kind, kinds)));
}

}  // namespace

ModelKind::TurningForce unbalance_on(const Rotor& r, const std::vector<Unbalance>& masses) {
  ModelKind::TurningForce f{ComplexVector::Zero(r.size()), 0};
  const auto add = [&](Index i, const Complex& value) {
    if (i >= 0) f.per_speed2(i) += value;
  };
  for (std::size_t k = 0; k < masses.size(); ++k) {
    const Place p = place_of(r, masses[k].place);
    const double ratio = r.spools()[p.station->spool].speed_ratio;
    if (k > 0 && ratio != f.speed_ratio)
      throw InvalidArgument(
          fmt::format("unbalance '{}' turns {:g} times as fast as the rotor and '{}' {:g} times: they drive at different "
                      "frequencies, so ask for one at a time",
                      masses.front().place, f.speed_ratio, masses[k].place, ratio));
    f.speed_ratio = ratio;
    if (ratio == 0) throw InvalidArgument(fmt::format("unbalance '{}': its shaft does not turn (speed_ratio 0)", masses[k].place));
    const auto& c = p.station->coordinate;
    auto [x, y] = components(masses[k]);
    x *= ratio * ratio;  // U(rΩ)²
    y *= ratio * ratio;
    add(c[0], x);
    add(c[1], y);
    add(c[3], p.beyond * x);  // the centre of a disc: x + beyond θy, y − beyond θx
    add(c[2], -p.beyond * y);
  }
  if (!(f.per_speed2.cwiseAbs().maxCoeff() > 0)) throw InvalidArgument("the unbalance is zero, or where the rotor is held: nothing moves");
  return f;
}

ModelKind::TurningForce unbalance_at(const std::vector<OrbitCoordinates>& places, const Labels& labels,
                                     const std::vector<Unbalance>& masses) {
  ModelKind::TurningForce f{ComplexVector::Zero(static_cast<Index>(labels.size())), 1};
  std::vector<std::string_view> known;
  for (const OrbitCoordinates& p : places) known.emplace_back(labels[static_cast<std::size_t>(p.x)]);
  for (const Unbalance& u : masses) {
    const auto at = std::find(known.begin(), known.end(), u.place);
    if (at == known.end())
      throw InvalidArgument(
          fmt::format("unbalance '{}': the first label of one of the 'orbits' was expected{}", u.place, suggestion(u.place, known)));
    const OrbitCoordinates& p = places[static_cast<std::size_t>(at - known.begin())];
    const auto [x, y] = components(u);
    f.per_speed2(p.x) += x;
    f.per_speed2(p.y) += y;
  }
  if (!(f.per_speed2.cwiseAbs().maxCoeff() > 0)) throw InvalidArgument("the unbalance is zero: nothing moves");
  return f;
}

}  // namespace gyromode
