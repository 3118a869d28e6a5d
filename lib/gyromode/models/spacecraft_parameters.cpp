// The parameters of a spacecraft: its spin, and every number of its parts.
#include "gyromode/models/part_parameters.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/spacecraft/part_numbers.h"

namespace gyromode {

namespace {

struct Parts {
  double spin;
  Body body;
  std::vector<Cable> cables;
  std::vector<Beam> beams;
  std::vector<SpringMass> masses;

  explicit Parts(const Spacecraft& s) : spin(s.spin()), body(s.body()), cables(s.cables()), beams(s.beams()), masses(s.masses()) {}

  template <class See>
  void operator()(See&& see) {
    see(std::string("spin"), Dimension::frequency, spin, static_cast<double*>(nullptr));
    each_parameter_of(body, "body", see);
    each_parameter_of_all(cables, "cable", see);
    each_parameter_of_all(beams, "beam", see);
    each_parameter_of_all(masses, "spring_mass", see);
  }
};

}  // namespace

std::vector<Parameter> SpacecraftModel::parameters() const { return listed_parameters(Parts(spacecraft_)); }

std::shared_ptr<const ModelKind> SpacecraftModel::with(const std::vector<ParameterValue>& values) const {
  Parts parts(spacecraft_);
  set_parameters(parts, values);
  return std::make_shared<SpacecraftModel>(
      Spacecraft(parts.spin, parts.body, std::move(parts.cables), std::move(parts.beams), std::move(parts.masses)));
}

}  // namespace gyromode
