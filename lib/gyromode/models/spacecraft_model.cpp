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

// Orbits of the tilt, about axes 1 and 2 of the turning axes.
SpinSource SpacecraftModel::spin_source() const {
  const auto at = [s = spacecraft_](double spin) { return Spacecraft(spin, s.body(), s.cables(), s.beams(), s.masses()); };
  SpinSource source;
  source.modes = [at](double spin, const ModesOptions& options) { return find_modes(at(spin), options); };
  source.impedance = [at](double omega, double spin) { return impedance_at(at(spin), omega); };
  source.places = {{3, 4}};
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
  return report;
}

std::shared_ptr<const ModelKind> SpacecraftModel::discretised(std::optional<Index> elements) const {
  return std::make_shared<TwinModel>(spacecraft_, Mesh{elements.value_or(Mesh{}.elements), 1});
}

}  // namespace gyromode
