// Row j: the verdict over 200 spins at 60 coordinates: a model that keeps its parts as data, beside a model file read
// for every spin.
#include "machine.h"
#include "rows.h"
#include "systems.h"

#include "gyromode/models/model_kind.h"
#include "gyromode/models/stability_over.h"
#include "gyromode/read/read_model.h"

#include <fmt/format.h>

#include <string>

namespace gyromode::bench {

namespace {

std::string rows_of(const Matrix& a) {
  std::string text = "[";
  for (Index i = 0; i < a.rows(); ++i) {
    text += i == 0 ? "[" : ",[";
    for (Index k = 0; k < a.cols(); ++k) text += fmt::format("{}{}", k == 0 ? "" : ",", a(i, k));
    text += "]";
  }
  return text + "]";
}

}  // namespace

std::vector<Row> sweep_rows(const RowOptions& options) {
  constexpr std::uint64_t seed = 1979;
  constexpr int spins = 200;
  const Index n = scaled_order(60, options);
  const System system = general_definite(n, seed);
  const SpinFamily family{system.mass(), Matrix::Zero(n, n), system.gyroscopic(), system.stiffness(), Matrix(-1e-3 * system.mass()), {}};
  const Model model(family, 1);
  ParameterAxis axis{"spin", {}};
  for (int k = 0; k < spins; ++k) axis.values.push_back(0.01 + k * 0.99 / (spins - 1));
  const std::string matrices = fmt::format(
      "kind = \"matrices\"\nmass = {}\nstiffness = {}\ngyroscopic_per_spin = {}\nstiffness_per_spin2 = {}\n", rows_of(family.mass),
      rows_of(family.stiffness), rows_of(family.gyroscopic_per_spin), rows_of(family.stiffness_per_spin2));
  const Contestant data{"stability_over", "one model, its spin varied", {}, [&] { model.stability_over({axis}); }};
  const Contestant files{"parse_model", "a model read from text for every spin", {}, [&] {
                           for (const double spin : axis.values)
                             parse_model(fmt::format("spin = {}\n{}", spin, matrices), "m.toml").body->verdict(false);
                         }};
  const Others others;
  Row row{"j", fmt::format("verdict over {} spins, general, K > 0, n = {}", spins, n), {}, 0, interleaved({data, files}, options.rounds)};
  row.others = others.share();
  return {row};
}

}  // namespace gyromode::bench
