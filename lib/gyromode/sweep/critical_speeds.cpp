#include "gyromode/sweep/critical_speeds.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sweep/family_structure.h"
#include "gyromode/sweep/pencil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

bool empty_or_zero(const Matrix& a) { return a.size() == 0 || a.cwiseAbs().maxCoeff() == 0; }

// What the parts of the model have found and counted.
struct Tally {
  Index counted = 0;
  bool sure = true;
  std::string reason;
  double reach = infinity;  // where the nearest root that may be at infinity may be

  void doubt(const std::string& why) {
    if (sure) reason = why;
    sure = false;
  }
};

double square(double x) { return x * x; }

// Of one part: its speeds of the window, and a count between the ends.
void add_part(const SpeedPencil& pencil, const CriticalOptions& o, Index n, CriticalSpeeds& all, Tally& tally) {
  constexpr double real_to = 1e-6;  // |Im ν| / |ν| of a real root before it is polished
  const std::vector<SpeedPencil::Root> roots = pencil.roots();
  double largest = 0;
  Index found = 0;
  for (const SpeedPencil::Root& rough : roots) {
    const bool real = std::abs(rough.nu.imag()) <= real_to * std::abs(rough.nu);
    if (real && pencil.is_at_infinity(rough)) {
      tally.reach = std::min(tally.reach, pencil.least_speed(rough));
      continue;
    }
    if (!real || !(rough.nu.real() > 0)) {
      ++all.not_physical;
      continue;
    }
    largest = std::max(largest, rough.nu.real());
    if (std::sqrt(rough.nu.real()) > 1.01 * o.window.b || std::sqrt(rough.nu.real()) < 0.99 * o.window.a) continue;
    const SpeedPencil::Root root = pencil.polished(rough);
    const double nu = root.nu.real();
    if (!(nu > 0) || !o.window.contains(std::sqrt(nu))) continue;
    CriticalSpeed c;
    c.speed = std::sqrt(nu);
    c.multiple = o.order;
    c.residual = pencil.residual(root);
    c.error_bound = pencil.error_of(root) / (2 * c.speed);
    c.shape = ComplexVector::Zero(n);
    c.shape(pencil.coordinates()) = root.shape;
    c.shape = normalised(std::move(c.shape));
    all.speeds.push_back(std::move(c));
    ++found;
  }
  const Index at_zero = pencil.negative_at_zero();
  const auto below = [&](double speed) {
    if (speed == 0) return at_zero;
    const Inertia i = pencil.inertia_at(square(speed));
    if (i.doubtful()) tally.doubt(fmt::format("K₀ − Ω²B is singular to rounding at Ω = {:.6g}", speed));
    return i.negative;
  };
  const double end = std::isinf(o.window.b) ? 1.125 * std::sqrt(largest) + (largest == 0 ? 1 : 0) : o.window.b;
  const Index counted = below(end) - below(o.window.a);
  tally.counted += counted;
  if (counted != found) tally.doubt("the count by factorisations is another, as signs of a pencil with K₀ indefinite may cancel");
}

}  // namespace

CriticalSpeeds critical_speeds(const SpinFamily& family, const CriticalOptions& options, const std::vector<OrbitCoordinates>& stations) {
  require_window(options.window);
  if (!(options.order >= 0) || !std::isfinite(options.order))
    throw InvalidArgument(fmt::format("order {}: a multiple of the speed, 0 or more, was expected", options.order));
  if (options.order > 0 && !empty_or_zero(family.gyroscopic))
    throw NotApplicable(
        "critical speeds come from one pencil where G goes with the spin alone: 'gyroscopic' beside 'gyroscopic_per_spin' is not 0");
  CriticalOptions o = options;
  const Structure structure = structure_of(family);
  CriticalSpeeds all;
  all.order = o.order;
  Tally tally;
  for (const Component& c : structure.components) {
    const SpeedPencil pencil(family, o.order, c.coordinates, c.in_quadrature, c.quadrature());
    add_part(pencil, o, family.mass.rows(), all, tally);
  }
  std::stable_sort(all.speeds.begin(), all.speeds.end(), [](const CriticalSpeed& a, const CriticalSpeed& b) { return a.speed < b.speed; });
  for (CriticalSpeed& c : all.speeds) c.whirl = whirl_of(c.shape, stations);
  Coverage& coverage = all.coverage;
  coverage.window = coverage.requested = o.window;
  coverage.found = static_cast<Index>(all.speeds.size());
  coverage.counted = tally.counted;
  coverage.reason = tally.reason;
  coverage.window.b = std::min(coverage.window.b, tally.reach);
  coverage.status = !tally.sure                       ? CoverageStatus::not_counted
                    : tally.counted == coverage.found ? CoverageStatus::complete
                                                      : CoverageStatus::incomplete;
  if (o.lowest && static_cast<Index>(all.speeds.size()) > *o.lowest) {
    all.speeds.resize(static_cast<std::size_t>(*o.lowest));
    coverage.window.b = std::nextafter(all.speeds.back().speed, std::numeric_limits<double>::infinity());
    coverage.found = *o.lowest;
    if (coverage.status == CoverageStatus::complete) coverage.counted = *o.lowest;
  }
  return all;
}

}  // namespace gyromode
