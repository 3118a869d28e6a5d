#include "gyromode/models/sparse_matrices_model.h"

#include "gyromode/base/error.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/response_facts.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/windowed_motion.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/stiffness.h"

#include <fmt/format.h>

#include <utility>

namespace gyromode {

namespace {

using NamedNumbers = std::vector<std::pair<std::string, double>>;

// What the motion is made of, and what is not in it.
std::string words_of(const WindowedMotion& m) {
  const ModesResult& modes = m.modes();
  std::string words = fmt::format("made of the {} modes below {:.6g} rad/s", m.modal().size(),
                                  modes.coverage.window.open() && !m.modal().empty() ? m.modal().back().omega : modes.coverage.window.b);
  if (modes.coverage.window.a > 0) words += fmt::format(" and from {:.6g} rad/s on", modes.coverage.window.a);
  if (m.initial_energy() != 0)
    words += fmt::format("; {:.3g} % of the energy of the initial motion is in others, and left out",
                         100 * m.energy_left_out() / m.initial_energy());
  if (m.with_steady_parts()) words += "; what lasting forces do to others is their steady part, there from t = 0 on";
  if (m.free_under_steps()) words += "; what a step does to the body as a whole, and to other modes, is left out";
  return words;
}

double largest_entry_of(const SparseMatrix& a) { return a.nonZeros() > 0 ? a.coeffs().cwiseAbs().maxCoeff() : 0; }

}  // namespace

ModesResult SparseMatricesModel::modes(const ModesOptions& options) const { return find_modes(system_, options); }

CountResult SparseMatricesModel::count(const Window& window) const { return count_modes(system_, window); }

StructureReport SparseMatricesModel::structure(std::optional<double> at) const {
  if (at) throw NotApplicable("--at writes H(ω) in full, which a large sparse model has no use for");
  StructureReport r;
  const Structure s = sparse::analyse(system_);
  r.structure = system_.basis() ? system_.basis()->given : s;
  const sparse::StiffnessFactors stiffness(system_, sparse::groups_of(s, system_.size()));
  r.stiffness = {stiffness.negative(), stiffness.nullity()};
  const auto named = [&](const auto& number) {
    return NamedNumbers{
        {"mass", number(system_.mass())}, {"gyroscopic", number(system_.gyroscopic())}, {"stiffness", number(system_.stiffness())}};
  };
  r.checks.push_back({"scales", named(largest_entry_of)});
  r.checks.push_back({"entries", named([](const SparseMatrix& a) { return static_cast<double>(a.nonZeros()); })});
  return r;
}

ResponseReport SparseMatricesModel::response(const MotionRequest& request) const {
  if (!request.points.empty()) throw InvalidArgument("--points are places on the booms of a spacecraft model");
  ModesOptions modes;
  modes.window = request.window;
  modes.lowest = request.lowest;
  modes.progress = request.progress;
  const WindowedMotion motion(system_, request.initial, request.forces, modes, request.chosen);
  ResponseReport report;
  report.labels = request.chosen.empty() ? labels() : labels_at(labels(), request.chosen);
  add_motion(motion, request, report);
  report.stability = motion.modes().stability;
  report.initial_energy = motion.initial_energy();
  report.energy_left_out = motion.energy_left_out();
  report.coverage = motion.modes().coverage;
  report.balance_closed = motion.modes().index_balance.closed;
  report.remark = words_of(motion);
  return report;
}

FrequencyReport SparseMatricesModel::frequency_response(const FrequencyRequest& request) const {
  return {request.chosen.empty() ? labels() : labels_at(labels(), request.chosen),
          gyromode::frequency_response(system_, request.amplitude, request.grid, request.chosen, true, request.progress)};
}

std::vector<std::string> SparseMatricesModel::doubts(bool) const {
  if (!system_.singular_mass()) return {};
  return {"M is singular to rounding, as elements of reduced integration leave it: motions without mass have no frequency of their own"};
}

std::shared_ptr<const ModelKind> model_of_sparse(SparseMatrices m) {
  constexpr Index few = 1000;
  if (m.mass.cols() > few || SparseSystem(m).singular_mass()) return std::make_shared<SparseMatricesModel>(std::move(m));
  SpinFamily family{sparse::full(m.mass, 1), sparse::full(m.gyroscopic, -1), {}, sparse::full(m.stiffness, 1), {}, std::move(m.labels), {}};
  return model_of({std::make_shared<const SpinFamily>(std::move(family)), std::nullopt});
}

}  // namespace gyromode
