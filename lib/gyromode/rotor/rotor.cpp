#include "gyromode/rotor/rotor.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

template <class Part>
void require_lawful(const std::vector<Part>& parts, const char* name) {
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (const auto b = broken_law(parts[k])) throw LawBroken(fmt::format("{} {}: {}", name, k + 1, b->law));
  }
}

template <class Named>
std::string suggested(const std::string& name, const std::vector<Named>& all) {
  std::vector<std::string_view> known;
  for (const Named& n : all) known.push_back(n.name);
  return suggestion(name, known);
}

// Parts, the lower end of the shaft, its upper one.
void require_on_shaft(const std::string& part, double position, const Spool& spool, double end, double tolerance) {
  if (position >= spool.start - tolerance && position <= end + tolerance) return;
  throw LawBroken(fmt::format("{}: position {:.6g} m is off the shaft{}, which reaches from {:.6g} to {:.6g} m", part, position,
                              spool.name.empty() ? "" : fmt::format(" '{}'", spool.name), spool.start, end));
}

// Ascending, without those nearer than `tolerance` to the one before.
std::vector<double> different(std::vector<double> places, double tolerance) {
  std::sort(places.begin(), places.end());
  std::vector<double> kept;
  for (const double z : places) {
    if (kept.empty() || z - kept.back() > tolerance) kept.push_back(z);
  }
  return kept;
}

// A section is parted where parts are on it, and every piece into elements of equal length by its share of them: no
// element is short but between parts that are near each other.
void add_nodes(double start, double end, Index elements, const std::vector<double>& parts, double tolerance, std::vector<double>& to) {
  constexpr double longer = 0.05;  // of an element: the count stays where a part moves a little
  std::vector<double> cuts{start, end};
  for (const double z : parts) {
    if (z > start + tolerance && z < end - tolerance) cuts.push_back(z);
  }
  cuts = different(std::move(cuts), tolerance);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const double piece = cuts[k + 1] - cuts[k];
    const auto count = std::max(1.0, std::ceil(static_cast<double>(elements) * piece / (end - start) - longer));
    for (double e = 0; e < count; ++e) to.push_back(cuts[k] + piece * e / count);
  }
  to.push_back(end);
}

}  // namespace

Rotor::Rotor(RotorParts parts) : parts_(std::move(parts)), spools_(parts_.spools) {
  if (spools_.empty()) spools_.push_back({});
  require_parts();
  place_stations();
  number_coordinates();
}

std::size_t Rotor::spool_named(const std::string& name) const {
  const auto at = std::find_if(spools_.begin(), spools_.end(), [&](const Spool& s) { return s.name == name; });
  if (at != spools_.end()) return static_cast<std::size_t>(at - spools_.begin());
  if (name.empty())
    throw LawBroken("every shaft, disc, bearing and support must name its spool, where there are several: 'spool' is missing");
  throw LawBroken(fmt::format("'{}' is no spool of the rotor{}", name, suggested(name, spools_)));
}

const Material& Rotor::material_named(const std::string& name) const {
  const auto at = std::find_if(parts_.materials.begin(), parts_.materials.end(), [&](const Material& m) { return m.name == name; });
  if (at != parts_.materials.end()) return *at;
  throw LawBroken(fmt::format("material '{}' is not given: a table [material.{}] was expected{}", name, name,
                              parts_.materials.empty() ? "" : suggested(name, parts_.materials)));
}

void Rotor::require_parts() const {
  for (const Material& m : parts_.materials) {
    if (const auto b = broken_law(m)) throw LawBroken(fmt::format("material '{}': {}", m.name, b->law));
  }
  if (parts_.shafts.empty()) throw LawBroken("a rotor must have a shaft: at least one section was expected");
  require_lawful(spools_, "spool");
  require_lawful(parts_.shafts, "shaft");
  require_lawful(parts_.discs, "disk");
  require_lawful(parts_.bearings, "bearing");
  require_lawful(parts_.point_masses, "point mass");
  if (!std::isfinite(parts_.speed) || !std::isfinite(parts_.axial_force)) throw LawBroken("speed and axial force must be finite");
  for (const ShaftSection& s : parts_.shafts) material_named(s.material);
  for (const Disc& d : parts_.discs) {
    if (d.geometry) material_named(d.geometry->material);
  }
}

void Rotor::place_stations() {
  constexpr double same = 1e-9;  // of the length of the rotor
  double length = 0;
  for (const Spool& s : spools_) ends_.push_back(s.start);
  for (const ShaftSection& s : parts_.shafts) {
    ends_[spool_named(s.spool)] += s.length;
    length += s.length;
  }
  tolerance_ = same * length;
  const std::vector<std::vector<double>> parts = places_of_parts();
  std::vector<double> at;  // the lower end of the next section of every spool
  std::vector<std::vector<double>> places(spools_.size());
  for (const Spool& s : spools_) at.push_back(s.start);
  for (const ShaftSection& s : parts_.shafts) {
    const std::size_t spool = spool_named(s.spool);
    add_nodes(at[spool], at[spool] + s.length, s.elements, parts[spool], tolerance_, places[spool]);
    at[spool] += s.length;
  }
  for (std::size_t spool = 0; spool < spools_.size(); ++spool) {
    if (places[spool].empty()) throw LawBroken(fmt::format("spool '{}' has no shaft", spools_[spool].name));
    for (const double z : different(places[spool], tolerance_)) stations_.push_back({spool, z, {0, 0, 0, 0}});
  }
}

// Where discs, bearings, supports and masses are, by spool.
std::vector<std::vector<double>> Rotor::places_of_parts() const {
  std::vector<std::vector<double>> places(spools_.size());
  const auto add = [&](const char* name, std::size_t k, double position, const std::string& on) {
    const std::size_t spool = spool_named(on);
    require_on_shaft(fmt::format("{} {}", name, k + 1), position, spools_[spool], ends_[spool], tolerance_);
    places[spool].push_back(std::clamp(position, spools_[spool].start, ends_[spool]));
  };
  for (std::size_t k = 0; k < parts_.discs.size(); ++k) add("disk", k, parts_.discs[k].position, parts_.discs[k].spool);
  for (std::size_t k = 0; k < parts_.supports.size(); ++k) add("support", k, parts_.supports[k].position, parts_.supports[k].spool);
  for (std::size_t k = 0; k < parts_.point_masses.size(); ++k)
    add("point mass", k, parts_.point_masses[k].position, parts_.point_masses[k].spool);
  for (std::size_t k = 0; k < parts_.bearings.size(); ++k) {
    const Bearing& b = parts_.bearings[k];
    add("bearing", k, b.position, b.spool);
    if (!b.to.empty()) add("bearing", k, b.position, b.to);
  }
  return places;
}

const Station& Rotor::station_at(std::size_t spool, double position) const {
  const auto at = std::find_if(stations_.begin(), stations_.end(),
                               [&](const Station& s) { return s.spool == spool && std::abs(s.position - position) <= 2 * tolerance_; });
  if (at == stations_.end()) throw InvalidArgument(fmt::format("there is no station at {:.6g} m", position));
  return *at;
}

// Coordinates that are held, or pinned to one another, are the same class; −1 is the ground.
void Rotor::number_coordinates() {
  const std::size_t count = 4 * stations_.size();
  std::vector<std::size_t> parent(count + 1);  // the last is the ground
  for (std::size_t k = 0; k <= count; ++k) parent[k] = k;
  const auto root = [&](std::size_t k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  const auto join = [&](std::size_t a, std::size_t b) { parent[std::min(root(a), root(b))] = std::max(root(a), root(b)); };
  const auto coordinate = [&](const std::string& spool, double position, std::size_t direction) {
    return 4 * static_cast<std::size_t>(&station_at(spool_named(spool), position) - stations_.data()) + direction;
  };
  for (const Support& s : parts_.supports) {
    const bool held[4] = {s.x, s.y, s.tilt_x, s.tilt_y};
    for (std::size_t d = 0; d < 4; ++d) {
      if (held[d]) join(coordinate(s.spool, s.position, d), count);
    }
  }
  // A pinned direction of a bearing with a housing is the housing itself: x and y of it are the station's then.
  for (const Bearing& b : parts_.bearings) {
    const double k[4] = {b.kxx, b.kyy, b.tilt_xx, b.tilt_yy};
    for (std::size_t d = 0; d < 4; ++d) {
      if (std::isfinite(k[d]) || (d < 2 && b.has_housing())) continue;
      join(coordinate(b.spool, b.position, d), b.to.empty() ? count : coordinate(b.to, b.position, d));
    }
  }
  const char* names[4] = {"x", "y", "theta_x", "theta_y"};
  std::vector<Index> number(count + 1, -2);
  number[root(count)] = -1;
  std::vector<std::size_t> of_spool(spools_.size(), 0);
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    Station& s = stations_[k];
    const std::size_t which = ++of_spool[s.spool];
    for (std::size_t d = 0; d < 4; ++d) {
      Index& of_class = number[root(4 * k + d)];
      if (of_class == -2) {
        of_class = static_cast<Index>(labels_.size());
        labels_.push_back(fmt::format("{}{}{}{}", spools_[s.spool].name, spools_[s.spool].name.empty() ? "" : ".", names[d], which));
      }
      s.coordinate[d] = of_class;
    }
  }
  for (std::size_t k = 0; k < parts_.bearings.size(); ++k) {
    const Bearing& b = parts_.bearings[k];
    std::array<Index, 2> own{-1, -1};
    if (b.has_housing()) {
      const Station& s = station_at(spool_named(b.spool), b.position);
      const bool pinned[2] = {!std::isfinite(b.kxx), !std::isfinite(b.kyy)};
      for (std::size_t d = 0; d < 2; ++d) {
        own[d] = pinned[d] ? s.coordinate[d] : static_cast<Index>(labels_.size());
        if (!pinned[d]) labels_.push_back(fmt::format("bearing{}.{}", k + 1, names[d]));
      }
    }
    housings_.push_back(own);
  }
  if (labels_.empty()) throw LawBroken("every coordinate of the rotor is held: nothing moves");
}

}  // namespace gyromode
