#include "gyromode/models/rotor_model.h"

#include "gyromode/base/rounding.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/part_parameters.h"
#include "gyromode/models/unbalance.h"
#include "gyromode/rotor/outline.h"
#include "gyromode/rotor/part_numbers.h"
#include "gyromode/rotor/part_energies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// Every number of the parts.
struct Numbers {
  RotorParts& p;

  template <class See>
  void operator()(See&& see) {
    see(std::string("speed"), Dimension::frequency, p.speed, static_cast<double*>(nullptr));
    see(std::string("axial_force"), Dimension::force, p.axial_force, static_cast<double*>(nullptr));
    for (Material& m : p.materials) each_parameter_of(m, "material." + m.name, see);
    each_parameter_of_all(p.shafts, "shaft", see);
    each_parameter_of_all(p.discs, "disk", see);
    each_parameter_of_all(p.bearings, "bearing", see);
    each_parameter_of_all(p.supports, "support", see);
    each_parameter_of_all(p.point_masses, "point_mass", see);
    for (Spool& s : p.spools) each_parameter_of(s, "spool." + s.name, see);
  }
};

// A bearing whose stiffness keeps fewer than three digits in the sum with the shaft's, in a sentence; or nothing.
std::string lost_by_rounding(const Rotor& r, const Matrix& stiffness, std::size_t which) {
  constexpr double digits = 1e3;
  const Bearing& b = r.parts().bearings[which];
  const Station& s = r.station_at(r.spool_named(b.spool), b.position);
  const std::pair<const char*, double> springs[] = {{"kxx", b.kxx}, {"kyy", b.kyy}, {"tilt_xx", b.tilt_xx}, {"tilt_yy", b.tilt_yy}};
  for (std::size_t d = 0; d < 4; ++d) {
    const auto& [key, k] = springs[d];
    const Index c = s.coordinate[d];
    if (c < 0 || !(k > 0) || k > digits * epsilon * stiffness(c, c)) continue;
    return fmt::format(
        "bearing {}: {} = {:g} is lost by rounding beside the shaft's stiffness {:.3g} there: motions that it alone holds are not "
        "determined",
        which + 1, key, k, stiffness(c, c));
  }
  return {};
}

}  // namespace

RotorModel::RotorModel(const Rotor& rotor) : RotorModel(rotor, std::make_shared<const SpinFamily>(assembled(rotor))) {}

RotorModel::RotorModel(const Rotor& rotor, std::shared_ptr<const SpinFamily> family)
    : DelegatingModel(model_of({family, rotor.parts().speed, {}})), rotor_(rotor), family_(std::move(family)) {}

// The stiffness of an element goes with 1/l³: one a hundredth of the shaft's diameter long takes some six digits.
std::vector<std::string> RotorModel::doubts(bool fixed_axes) const {
  constexpr double short_to = 0.01;
  std::vector<std::string> all = DelegatingModel::doubts(fixed_axes);
  double thickest = 0;
  for (const ShaftSection& s : rotor_.parts().shafts) thickest = std::max({thickest, s.outer_diameter[0], s.outer_diameter[1]});
  const std::vector<Station>& stations = rotor_.stations();
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    const double length = stations[k + 1].position - stations[k].position;
    if (stations[k].spool != stations[k + 1].spool || length > short_to * thickest) continue;
    all.push_back(
        fmt::format("parts at {:.9g} and {:.9g} m are {:.3g} m apart, and so short an element costs digits: put them at one place",
                    stations[k].position, stations[k + 1].position, length));
  }
  for (std::size_t k = 0; k < rotor_.parts().bearings.size(); ++k) {
    const std::string lost = lost_by_rounding(rotor_, family_->stiffness, k);
    if (!lost.empty()) all.push_back(lost);
  }
  return all;
}

ModesResult RotorModel::modes(const ModesOptions& options) const {
  ModesResult r = DelegatingModel::modes(options);
  if (!options.shapes) return r;
  r.outlines = outlines_of(rotor_);
  for (Mode& m : r.modes) {
    if (m.shape.size() == size()) m.field = displacements_of(rotor_, r.outlines, m.shape);
  }
  return r;
}

CriticalSpeeds RotorModel::critical_speeds(const CriticalOptions& options) const {
  return gyromode::critical_speeds(*family_, options, orbits());
}

ModelKind::TurningForce RotorModel::unbalance(const std::vector<Unbalance>& masses) const { return unbalance_on(rotor_, masses); }

// Stations are named as in labels: counted along their spool.
std::vector<OrbitCoordinates> RotorModel::orbits() const {
  std::vector<OrbitCoordinates> places;
  std::vector<std::size_t> count(rotor_.spools().size(), 0);
  for (const Station& s : rotor_.stations()) {
    const std::string& spool = rotor_.spools()[s.spool].name;
    const std::size_t which = ++count[s.spool];
    if (s.coordinate[0] < 0 || s.coordinate[1] < 0) continue;
    places.push_back({s.coordinate[0], s.coordinate[1], fmt::format("{}{}station {}", spool, spool.empty() ? "" : " ", which), s.position});
  }
  return places;
}

// Places, tilts, housings: of coordinates that are pinned together one pair.
std::vector<OrbitCoordinates> RotorModel::transverse() const {
  std::vector<OrbitCoordinates> all;
  const auto add = [&](Index x, Index y) {
    const bool known = std::any_of(all.begin(), all.end(), [&](const OrbitCoordinates& p) { return p.x == x && p.y == y; });
    if (x >= 0 && y >= 0 && !known) all.push_back({x, y});
  };
  for (const Station& s : rotor_.stations()) {
    add(s.coordinate[0], s.coordinate[1]);
    add(s.coordinate[2], s.coordinate[3]);
  }
  for (std::size_t k = 0; k < rotor_.parts().bearings.size(); ++k) add(rotor_.housing(k)[0], rotor_.housing(k)[1]);
  return all;
}

// By sections of shaft, discs, point masses and bearings.
std::vector<EnergyShare> RotorModel::energy_shares(const Mode& mode, const std::vector<ModelOutline>&) const {
  if (mode.shape.size() != size()) return {};
  std::vector<EnergyShare> all;
  double kinetic = 0, strain = 0, sizes = 0;
  for (const PartEnergy& p : part_energies(rotor_, mode.shape)) {
    all.push_back({p.part, p.kinetic, p.strain});
    kinetic += p.kinetic;
    strain += p.strain;
    sizes += std::abs(p.strain);
  }
  for (EnergyShare& s : all) {
    s.kinetic /= kinetic;
    s.strain = strain > 1e-12 * sizes ? s.strain / strain : std::nan("");
  }
  return all;
}

SpinSource RotorModel::spin_source() const { return spin_source_of(family_, orbits(), transverse()); }

std::vector<Parameter> RotorModel::parameters() const {
  RotorParts parts = rotor_.parts();
  return listed_parameters(Numbers{parts});
}

std::shared_ptr<const ModelKind> RotorModel::with(const std::vector<ParameterValue>& values) const {
  RotorParts parts = rotor_.parts();
  set_parameters(Numbers{parts}, values);
  return std::make_shared<RotorModel>(Rotor(std::move(parts)));
}

// Without the checks and the certificates of a model, where no coordinate is condensed.
std::vector<Matrix> RotorModel::matrices_with(const std::vector<ParameterValue>& values) const {
  if (!massless().empty()) return ModelKind::matrices_with(values);
  RotorParts parts = rotor_.parts();
  set_parameters(Numbers{parts}, values);
  SpinFamily f = assembled(Rotor(parts));
  return {std::move(f.mass), parts.speed * f.gyroscopic_per_spin, std::move(f.stiffness)};
}

std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> RotorModel::without_couplings(double tolerance) const {
  return made()->without_couplings(tolerance);
}

}  // namespace gyromode
