#include "gyromode/models/matrices.h"

#include "gyromode/system/plausibility.h"

#include "gyromode/base/error.h"
#include "gyromode/models/unbalance.h"
#include "gyromode/models/response_facts.h"
#include "gyromode/stability/stability_margin.h"
#include "gyromode/structure/inertia_of_k.h"
#include "gyromode/structure/ignored_couplings.h"
#include "gyromode/structure/reversing_symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

using Numbers = std::vector<std::pair<std::string, double>>;

double largest(const Matrix& a) { return a.cwiseAbs().maxCoeff(); }

// In the scale of the rows that an entry is in; 0 of a matrix that needed no repair.
double departure_of(std::string_view matrix, const std::vector<Repair>& repairs) {
  for (const Repair& r : repairs) {
    if (r.matrix == matrix) return r.own_scale;
  }
  return 0;
}

}  // namespace

MatricesModel::MatricesModel(FamilyAtSpin matrices)
    : system_(matrices.family->at(matrices.spin.value_or(0))), matrices_(std::move(matrices)) {}

ModesResult MatricesModel::modes(const ModesOptions& options) const { return find_modes(system_, options); }

CountResult MatricesModel::count(const Window& window) const { return count_modes(system_, window); }

StabilityReport MatricesModel::stability(const Progress& progress) const {
  StabilityReport r = ModelKind::stability(progress);
  r.opposite = nearest_opposite_pair(r.result.modes);
  r.stiffness = stiffness_margin(system_, r.result.stiffness.zero);
  return r;
}

std::vector<std::string> MatricesModel::doubts(bool fixed_axes) const {
  if (fixed_axes) return {};  // softening there is none of turning axes
  std::vector<std::string> all = matrices_.family ? doubts_on(*matrices_.family) : std::vector<std::string>{};
  return all.empty() ? doubts_on(system_) : all;
}

CriticalSpeeds MatricesModel::critical_speeds(const CriticalOptions& options) const {
  if (!matrices_.family || !matrices_.spin) return ModelKind::critical_speeds(options);
  return gyromode::critical_speeds(*matrices_.family, options, matrices_.orbits);
}

ModelKind::TurningForce MatricesModel::unbalance(const std::vector<Unbalance>& masses) const {
  return matrices_.orbits.empty() ? ModelKind::unbalance(masses) : unbalance_at(matrices_.orbits, labels(), masses);
}

SpinSource MatricesModel::spin_source() const {
  return matrices_.family && matrices_.spin ? spin_source_of(matrices_.family, matrices_.orbits, matrices_.orbits)
                                            : ModelKind::spin_source();
}

// K₀ + Ω²K₂: those of Ω > 0, and their mirror images.
std::vector<double> MatricesModel::divergence_thresholds(std::string_view key, double a, double b) const {
  if (key != "spin" || !matrices_.family || !matrices_.spin || matrices_.family->stiffness_per_spin2.size() == 0) return {};
  CriticalOptions o;
  o.order = 0;
  o.window.b = std::nextafter(std::max(std::abs(a), std::abs(b)), std::numeric_limits<double>::infinity());
  std::vector<double> all;
  for (const CriticalSpeed& c : gyromode::critical_speeds(*matrices_.family, o).speeds) {
    for (const double spin : {-c.speed, c.speed}) {
      if (spin > a && spin < b) all.push_back(spin);
    }
  }
  return all;
}

StructureReport MatricesModel::structure(std::optional<double> at) const {
  StructureReport r;
  r.structure = analyse(system_, HiddenSearch::always);
  r.stiffness = inertia_of_k(system_.stiffness());
  for (const Component& c : r.structure.components) {
    if (!c.search) continue;
    SymmetryFinding f{c.coordinates, c.search->departure, c.search->threshold, c.search->amplification, std::nullopt};
    if (c.search->found) f.reflection = c.search->found->reflection(system_.mass()(c.coordinates, c.coordinates));
    r.symmetries.push_back(std::move(f));
  }
  const std::vector<Repair>& repairs = r.repairs = system_.repairs();
  r.checks = {{"symmetry_errors", Numbers{{"mass", departure_of("M", repairs)},
                                          {"gyroscopic", departure_of("G", repairs)},
                                          {"stiffness", departure_of("K", repairs)}}},
              {"scales", Numbers{{"mass", largest(system_.mass())},
                                 {"gyroscopic", largest(system_.gyroscopic())},
                                 {"stiffness", largest(system_.stiffness())}}},
              {"mass_trace", system_.mass().trace()}};
  if (at) r.at = {*at, realify(system_.impedance(*at), r.structure)};
  return r;
}

ResponseReport MatricesModel::response(const MotionRequest& request) const {
  if (!request.points.empty()) throw InvalidArgument("--points are places on the booms of a spacecraft model");
  const Response r(system_, request.initial, request.forces);
  ResponseReport report;
  report.labels = labels();
  add_facts(r, r, request, report);
  report.keep_only(request.chosen, size());
  return report;
}

FrequencyReport MatricesModel::frequency_response(const FrequencyRequest& request) const {
  FrequencyReport report{labels(), gyromode::frequency_response(system_, request.amplitude, request.grid, true, request.progress)};
  report.keep_only(request.chosen);
  return report;
}

std::vector<ModelKind::NamedMatrix> MatricesModel::matrices() const {
  return {{"M", "mass M", false, &system_.mass()},
          {"G", "gyroscopic G", true, &system_.gyroscopic()},
          {"K", "stiffness K", false, &system_.stiffness()}};
}

std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> MatricesModel::without_couplings(double tolerance) const {
  auto without = std::make_shared<MatricesModel>(without_ignored_couplings(system_, tolerance));
  without->left_out_ = {std::make_shared<const MatricesModel>(*this), tolerance};
  return {std::move(without), ignored_couplings(system_, tolerance)};
}

ModesResult FirstOrderModel::modes(const ModesOptions& options) const { return find_modes(system_, options); }

CountResult FirstOrderModel::count(const Window& window) const { return count_modes(system_, window); }

StructureReport FirstOrderModel::structure(std::optional<double> at) const {
  StructureReport r;
  r.structure = analyse(system_);
  r.stiffness_applies = false;
  const std::vector<Repair>& repairs = r.repairs = system_.repairs();
  r.checks = {{"symmetry_errors", Numbers{{"inertia", departure_of("I", repairs)}, {"gyroscopic", departure_of("G", repairs)}}},
              {"scales", Numbers{{"inertia", largest(system_.inertia())}, {"gyroscopic", largest(system_.gyroscopic())}}}};
  if (at) r.at = {*at, realify(system_.impedance(*at), r.structure)};
  return r;
}

std::vector<ModelKind::NamedMatrix> FirstOrderModel::matrices() const {
  return {{"I", "inertia I of I q' + G q = 0", false, &system_.inertia()},
          {"G", "gyroscopic G of I q' + G q = 0", true, &system_.gyroscopic()}};
}

std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> FirstOrderModel::without_couplings(double tolerance) const {
  auto without = std::make_shared<FirstOrderModel>(without_ignored_couplings(system_, tolerance));
  without->left_out_ = {std::make_shared<const FirstOrderModel>(*this), tolerance};
  return {std::move(without), ignored_couplings(system_, tolerance)};
}

std::optional<IgnoredCouplings> MatricesModel::left_out() const {
  return left_out_.whole ? std::optional(ignored_couplings(left_out_.whole->system_, left_out_.tolerance)) : std::nullopt;
}

std::optional<IgnoredCouplings> FirstOrderModel::left_out() const {
  return left_out_.whole ? std::optional(ignored_couplings(left_out_.whole->system_, left_out_.tolerance)) : std::nullopt;
}

}  // namespace gyromode
