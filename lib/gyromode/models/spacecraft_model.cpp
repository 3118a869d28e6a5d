#include "gyromode/models/spacecraft_model.h"

#include "gyromode/base/error.h"
#include "gyromode/elements/discretise.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/response_facts.h"
#include "gyromode/modes/discrete.h"
#include "gyromode/modes/spacecraft.h"
#include "gyromode/modes/spacecraft_spectrum.h"
#include "gyromode/motion/spacecraft_response.h"
#include "gyromode/spacecraft/clamped_booms.h"
#include "gyromode/modes/effective_axes.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

// Matrices, of which the modes of the body are named.
class TwinModel : public MatricesModel {
 public:
  TwinModel(const Spacecraft& s, const Mesh& mesh) : MatricesModel(discretise(s, mesh)), spacecraft_(s), mesh_(mesh) {}
  ModesResult modes(const ModesOptions& options) const override { return find_modes_of_twin(spacecraft_, mesh_, system(), options); }

 private:
  Spacecraft spacecraft_;
  Mesh mesh_;
};

}  // namespace

ModesResult SpacecraftModel::modes(const ModesOptions& options) const { return find_modes(spacecraft_, options); }

CountResult SpacecraftModel::count(const Window& window) const { return count_modes(spacecraft_, window); }

StructureReport SpacecraftModel::structure(std::optional<double> at) const {
  if (at && !(*at > 0)) throw InvalidArgument(fmt::format("--at {:g}: a frequency above 0 was expected", *at));
  constexpr Index lowest_of_a_boom = 5, lowest_modes = 10;
  const SpacecraftSpectrum solved(spacecraft_);
  ModesResult facts;
  solved.describe(facts, false);
  StructureReport r;
  r.structure = facts.structure;
  r.stiffness = facts.stiffness;
  r.clamped_booms = clamped_booms(spacecraft_, lowest_of_a_boom);
  r.effective_axes = effective_axes(solved, lowest_modes);
  r.checks = {
      {"mass", spacecraft_.rigid().mass}, {"centre_height", spacecraft_.centre()}, {"inertia", Matrix(spacecraft_.rigid().inertia())}};
  if (at) r.at = {*at, realify(impedance_at(spacecraft_, *at), r.structure)};
  return r;
}

namespace {

// Line density, and mass at the end, of what an outline is of: the boom of that root and direction, or the mass there.
std::pair<double, double> masses_of(const Spacecraft& s, const ModelOutline& line) {
  const Eigen::Vector3d root = line.points.front(), end = line.points.back();
  const auto is = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm() <= 1e-9 * (1 + a.norm()); };
  if (line.points.size() == 1) {
    for (const SpringMass& m : s.masses()) {
      if (is(root, m.position)) return {0, m.mass};
    }
  }
  for (const Cable& c : s.cables()) {
    const Eigen::Vector3d at = c.radius * c.direction() + Eigen::Vector3d(0, 0, c.height);
    if (is(root, at) && is(end, at + c.length * c.direction())) return {c.line_density, c.tip_mass};
  }
  for (const Beam& b : s.beams()) {
    const Eigen::Vector3d at(0, 0, b.root_height);
    if (is(root, at) && is(end, at + Eigen::Vector3d(0, 0, b.way() * b.length))) return {b.line_density, b.tip_mass};
  }
  return {0, 0};
}

// ∫ ρ|u|² along an outline by the trapezoidal rule, and a mass at its end.
double kinetic_along(const ModelOutline& line, const ComplexMatrix& field, double line_density, double tip_mass) {
  double sum = tip_mass * field.col(field.cols() - 1).squaredNorm();
  for (Index k = 0; k + 1 < field.cols(); ++k) {
    const double length = (line.points[static_cast<std::size_t>(k + 1)] - line.points[static_cast<std::size_t>(k)]).norm();
    sum += line_density * length * 0.5 * (field.col(k).squaredNorm() + field.col(k + 1).squaredNorm());
  }
  return sum;
}

}  // namespace

// Of body, booms and masses; of the booms by the points of their outlines. Springs and tension say nothing of strain
// apart from the spin.
std::vector<EnergyShare> SpacecraftModel::energy_shares(const Mode& mode, const std::vector<ModelOutline>& outlines) const {
  if (mode.shape.size() != size() || mode.field.size() != outlines.size()) return {};
  const Eigen::Vector3cd tilt = mode.shape.tail<3>(),
                         centre = mode.shape.head<3>() + Eigen::Vector3cd(-tilt(1), tilt(0), 0) * spacecraft_.centre();
  const Body& body = spacecraft_.body();
  std::vector<EnergyShare> all{{"body", body.mass * centre.squaredNorm() + std::real(tilt.dot(body.inertia.cast<Complex>() * tilt))}};
  for (std::size_t k = 0; k < outlines.size(); ++k) {
    const auto [line_density, end_mass] = masses_of(spacecraft_, outlines[k]);
    all.push_back({outlines[k].name, kinetic_along(outlines[k], mode.field[k], line_density, end_mass)});
  }
  double sum = 0;
  for (const EnergyShare& s : all) sum += s.kinetic;
  for (EnergyShare& s : all) s.kinetic /= sum;
  return sum > 0 ? all : std::vector<EnergyShare>{};
}

std::string SpacecraftModel::name_of(const Mode& mode, const std::vector<EnergyShare>& shares) const {
  if (mode.shape.size() != size()) return {};
  if (mode.kind == ModeKind::rigid_body) {
    if (mode.omega > 0) return "tilt of the momentum axis";
    return std::abs(mode.shape(2)) > std::abs(mode.shape(5)) ? "axial translation" : "spin phase";
  }
  if (mode.kind != ModeKind::vibration || shares.empty() || shares.front().kinetic < 0.5) return {};
  const std::vector<FixedAxesPart> parts = in_fixed_axes(mode.shape, mode.omega, spacecraft_.spin(), orbits());
  const auto most = std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) { return a.share < b.share; });
  const double tilt = mode.shape.segment<2>(3).norm(), turn = std::abs(mode.shape(5));
  return most != parts.end() && most->omega > 0 && tilt > turn ? "nutation" : "";
}

SpinSource SpacecraftModel::spin_source() const {
  const auto at = [s = spacecraft_](double spin) { return Spacecraft(spin, s.body(), s.cables(), s.beams(), s.masses()); };
  SpinSource source;
  source.modes = [at](double spin, const ModesOptions& options) { return find_modes(at(spin), options); };
  source.impedance = [at](double omega, double spin) { return impedance_at(at(spin), omega); };
  source.places = orbits();
  return source;
}

ResponseReport SpacecraftModel::response(const MotionRequest& request) const {
  const SpacecraftResponse r(spacecraft_, request.initial, request.forces, request.points);
  ResponseReport report;
  report.labels = r.labels();
  report.remark = fmt::format(
      "booms as {} elements of degree {} each, {} coordinates about the mass centre, which moves by itself; booms start undeformed",
      r.mesh().elements, r.mesh().degree, r.coordinates());
  add_facts(r, r.about_centre(), request, report);
  report.keep_only(request.chosen, size());
  return report;
}

std::shared_ptr<const ModelKind> SpacecraftModel::discretised(std::optional<Index> elements) const {
  return std::make_shared<TwinModel>(spacecraft_, Mesh{elements.value_or(Mesh{}.elements), 1});
}

}  // namespace gyromode
