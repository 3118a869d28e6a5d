// The parameters of a spacecraft: its spin, and every number of its parts.
#include "gyromode/base/error.h"
#include "gyromode/models/parameter_keys.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/spacecraft/part_numbers.h"

#include <fmt/format.h>

namespace gyromode {

namespace {

struct Parts {
  double spin;
  Body body;
  std::vector<Cable> cables;
  std::vector<Beam> beams;
  std::vector<SpringMass> masses;

  explicit Parts(const Spacecraft& s) : spin(s.spin()), body(s.body()), cables(s.cables()), beams(s.beams()), masses(s.masses()) {}
};

// Calls see(key, dimension, number, mirror image of it or null).
template <class Part, class See>
void each_parameter_of(Part& part, const std::string& name, See&& see) {
  each_number(part, [&](const NumberKey& k, std::span<double> numbers) {
    const std::string key = fmt::format("{}.{}", name, k.key);
    switch (k.form) {
      case NumberKey::Form::one:
      case NumberKey::Form::one_or_zero: see(key, k.dimension, numbers[0], static_cast<double*>(nullptr)); break;
      case NumberKey::Form::on_axis_3: see(key + "[2]", k.dimension, numbers[0], static_cast<double*>(nullptr)); break;
      case NumberKey::Form::several:
      case NumberKey::Form::several_or_infinite:
        for (std::size_t i = 0; i < numbers.size(); ++i)
          see(fmt::format("{}[{}]", key, i), k.dimension, numbers[i], static_cast<double*>(nullptr));
        break;
      case NumberKey::Form::symmetric:  // a principal value by one index, any entry by two
        for (std::size_t i = 0; i < 3; ++i) see(fmt::format("{}[{}]", key, i), k.dimension, numbers[4 * i], static_cast<double*>(nullptr));
        for (std::size_t i = 0; i < 3; ++i) {
          for (std::size_t j = 0; j < 3; ++j)
            see(fmt::format("{}[{}][{}]", key, i, j), k.dimension, numbers[3 * i + j], &numbers[3 * j + i]);
        }
        break;
    }
  });
}

template <class See>
void each_parameter(Parts& parts, See&& see) {
  see(std::string("spin"), Dimension::frequency, parts.spin, static_cast<double*>(nullptr));
  each_parameter_of(parts.body, "body", see);
  const auto each_of = [&](auto& all, const char* name) {
    for (std::size_t i = 0; i < all.size(); ++i) each_parameter_of(all[i], fmt::format("{}[{}]", name, i), see);
  };
  each_of(parts.cables, "cable");
  each_of(parts.beams, "beam");
  each_of(parts.masses, "spring_mass");
}

}  // namespace

std::vector<Parameter> SpacecraftModel::parameters() const {
  Parts parts(spacecraft_);
  std::vector<Parameter> all;
  each_parameter(parts, [&](const std::string& key, Dimension dimension, double& x, double*) { all.push_back({key, dimension, x}); });
  return all;
}

std::shared_ptr<const ModelKind> SpacecraftModel::with(const std::vector<ParameterValue>& values) const {
  Parts parts(spacecraft_);
  for (const ParameterValue& v : values) {
    bool any = false;
    each_parameter(parts, [&](const std::string& key, Dimension, double& x, double* mirror) {
      if (!names(v.key, key)) return;
      x = v.value;
      if (mirror) *mirror = v.value;
      any = true;
    });
    if (!any) throw InvalidArgument(fmt::format("'{}' is no parameter of the model", v.key));
  }
  for (const ParameterValue& v : values) {
    each_parameter(parts, [&](const std::string& key, Dimension, double& x, double*) {
      if (names(v.key, key) && x != v.value) {
        throw InvalidArgument(fmt::format("'{}' is given two values at once: another key names it, too", key));
      }
    });
  }
  return std::make_shared<SpacecraftModel>(
      Spacecraft(parts.spin, parts.body, std::move(parts.cables), std::move(parts.beams), std::move(parts.masses)));
}

}  // namespace gyromode
