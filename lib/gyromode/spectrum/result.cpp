#include "gyromode/spectrum/result.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <ostream>

namespace gyromode {

std::string_view to_string(ModeKind kind) {
  switch (kind) {
    case ModeKind::rigid_body: return "rigid_body";
    case ModeKind::local: return "local";
    default: return "vibration";
  }
}

std::string_view to_string(CoverageStatus status) {
  switch (status) {
    case CoverageStatus::complete: return "complete";
    case CoverageStatus::incomplete: return "incomplete";
    default: return "not_counted";
  }
}

std::string_view to_string(CountStatus status) {
  switch (status) {
    case CountStatus::exact: return "exact";
    case CountStatus::signed_only: return "signed_only";
    default: return "doubtful";
  }
}

std::vector<double> ModesResult::frequencies() const {
  std::vector<double> all;
  for (const Mode& m : modes) all.push_back(m.omega);
  return all;
}

void ModesResult::drop_shapes() {
  for (std::vector<Mode>* list : {&modes, &negative_modes}) {
    for (Mode& m : *list) {
      m.shape.resize(0);
      m.field.clear();
    }
  }
  for (UnstableMode& u : unstable) u.shape.resize(0);
  outlines.clear();
}

ComplexMatrix ModesResult::shapes() const {
  if (modes.empty()) return ComplexMatrix(0, 0);
  ComplexMatrix all(modes.front().shape.size(), static_cast<Index>(modes.size()));
  for (Index k = 0; k < all.cols(); ++k) {
    const ComplexVector& shape = modes[static_cast<std::size_t>(k)].shape;
    if (shape.size() == 0) throw InvalidArgument("shapes were not asked for: ModesOptions::shapes");
    all.col(k) = shape;
  }
  return all;
}

void ModesResult::withhold_doubtful_verdict() {
  const bool doubtful = std::any_of(repairs.begin(), repairs.end(), [](const Repair& r) { return r.doubtful(); });
  if (doubtful && stability < Stability::unknown) stability = Stability::unknown;
}

std::vector<std::string> ModesResult::remarks(std::optional<Index> lowest) const {
  std::vector<std::string> all;
  const Window &used = coverage.window, &asked = coverage.requested;
  if (!coverage.interrupted && (used.a != asked.a || (used.b != asked.b && !asked.open()))) {
    all.push_back(fmt::format("an end of the window falls on a mode: [{:.17g}, {:.17g}) rad/s was used", used.a, used.b));
  }
  const Index vibrations = std::count_if(modes.begin(), modes.end(), [](const Mode& m) { return m.kind != ModeKind::rigid_body; });
  if (lowest && vibrations > *lowest)
    all.push_back(fmt::format("mode {} coincides with the next: {} modes are listed", *lowest, vibrations));
  constexpr double last_digits = 16 * epsilon;  // every other program leaves that much
  for (const Repair& r : repairs) {
    if (r.own_scale > last_digits) all.push_back(r.in_words());
  }
  return all;
}

std::ostream& operator<<(std::ostream& out, const ModesResult& r) {
  for (const Mode& m : r.modes)
    out << fmt::format("{:.15g} rad/s, energy {}, {}\n", m.omega,
                       m.energy_sign > 0   ? "+"
                       : m.energy_sign < 0 ? "-"
                                           : "0",
                       to_string(m.kind));
  return out << fmt::format("{}; {}: found {}{}\n", to_string(r.stability), to_string(r.coverage.status), r.coverage.found,
                            r.coverage.counted ? fmt::format(", counted {}", *r.coverage.counted) : "");
}

}  // namespace gyromode
