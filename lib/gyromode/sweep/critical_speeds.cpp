#include "gyromode/sweep/critical_speeds.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sweep/family_structure.h"
#include "gyromode/sweep/pencil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
  const auto is_real = [](const SpeedPencil::Root& r) { return std::abs(r.nu.imag()) <= real_to * std::abs(r.nu); };
  double reach = infinity;  // of this part
  for (const SpeedPencil::Root& rough : roots) {
    if (is_real(rough) && pencil.is_at_infinity(rough)) reach = std::min(reach, pencil.least_speed(rough));
  }
  tally.reach = std::min(tally.reach, reach);
  double largest = 0;
  Index found = 0;
  for (const SpeedPencil::Root& rough : roots) {
    if (is_real(rough) && pencil.is_at_infinity(rough)) continue;
    if (!is_real(rough) || !(rough.nu.real() > 0)) {
      ++all.not_physical;
      continue;
    }
    if (!(std::sqrt(rough.nu.real()) < reach)) continue;
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
  double end = std::isinf(o.window.b) ? 1.125 * std::sqrt(largest) + (largest == 0 ? 1 : 0) : o.window.b;
  if (end >= reach) end = largest > 0 ? std::sqrt(std::sqrt(largest) * reach) : 0.5 * reach;
  const Index counted = below(end) - below(o.window.a);
  tally.counted += counted;
  if (counted != found) tally.doubt("the count by factorisations is another, as signs of a pencil with K₀ indefinite may cancel");
}

}  // namespace

bool coincide(const CriticalSpeed& a, const CriticalSpeed& b) {
  return std::abs(b.speed - a.speed) <= 4 * (a.error_bound + b.error_bound + epsilon * b.speed);
}

void keep_lowest(CriticalSpeeds& all, Index count) {
  auto kept = static_cast<std::size_t>(std::max<Index>(count, 0));
  if (kept >= all.speeds.size()) return;
  while (kept > 0 && kept < all.speeds.size() && coincide(all.speeds[kept - 1], all.speeds[kept])) ++kept;
  all.speeds.resize(kept);
  all.coverage.window.b = std::nextafter(all.speeds.back().speed, infinity);
  all.coverage.found = static_cast<Index>(kept);
  if (all.coverage.status == CoverageStatus::complete) all.coverage.counted = all.coverage.found;
}

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
  for (std::size_t k = 0; k < all.speeds.size(); ++k) {
    CriticalSpeed& c = all.speeds[k];
    c.whirl = whirl_of(c.shape, stations);
    const bool is_double = (k > 0 && coincide(all.speeds[k - 1], c)) || (k + 1 < all.speeds.size() && coincide(c, all.speeds[k + 1]));
    if (is_double && (c.whirl == Whirl::planar || c.whirl == Whirl::mixed)) c.whirl = Whirl::degenerate;
  }
  Coverage& coverage = all.coverage;
  coverage.window = coverage.requested = o.window;
  coverage.found = static_cast<Index>(all.speeds.size());
  coverage.counted = tally.counted;
  coverage.reason = tally.reason;
  coverage.window.b = std::min(coverage.window.b, tally.reach);
  coverage.status = !tally.sure                       ? CoverageStatus::not_counted
                    : tally.counted == coverage.found ? CoverageStatus::complete
                                                      : CoverageStatus::incomplete;
  if (o.lowest) keep_lowest(all, *o.lowest);
  return all;
}

}  // namespace gyromode
