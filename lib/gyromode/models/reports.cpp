#include "gyromode/models/reports.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode {

std::vector<std::string> ResponseReport::doubts() const {
  constexpr double loose = 1e-6;  // of the motion; rad
  std::vector<std::string> all;
  if (!balance_closed) all.emplace_back("the index balance does not close, so some motion may be missing");
  if (coverage && coverage->status != CoverageStatus::complete)
    all.push_back("the modes of the window may not be all: " + coverage->reason);
  if (!(departure <= loose)) {
    all.push_back(fmt::format(
        "the parts add up to what sets them in motion to {:.1e} only: modes so close to each other are not told apart", departure));
  }
  if (!(phase_error <= loose)) {
    const double last = history.t.size() > 0 ? history.t(history.t.size() - 1) : 0;
    all.push_back(fmt::format("at t = {:g} phases are known to {:.1e} rad only, the error bound of a frequency times t: ask for less time",
                              last, phase_error));
  }
  return all;
}

void ResponseReport::keep_only(const std::vector<Index>& chosen, Index n) {
  if (chosen.empty()) return;
  std::vector<Index> rows = chosen;
  for (Index i = n; i < static_cast<Index>(labels.size()); ++i) rows.push_back(i);
  labels = labels_at(labels, rows);
  history.q = Matrix(history.q(rows, Eigen::all));
  history.qdot = Matrix(history.qdot(rows, Eigen::all));
  for (ModalShare& m : modal) m.shape = ComplexVector(m.shape(rows));
}

Orbit UnbalanceReport::orbit(const SynchronousPoint& point, std::size_t place) const {
  if (response.order > 0) return orbit_of(point.q, places[place]);
  const double x = point.q(places[place].x).real(), y = point.q(places[place].y).real(), radius = std::hypot(x, y);
  return {radius, radius, 0};
}

std::vector<std::string> UnbalanceReport::remarks() const {
  std::vector<std::string> all;
  for (const SynchronousPoint& p : response.points) {
    if (!p.participation || p.added || p.driven == Driven::no) continue;
    const char* what = p.resonance()
                           ? "a critical speed that the unbalance drives: the response is unbounded there"
                           : "a critical speed, and whether the unbalance drives it cannot be told: the limit from both sides is given";
    all.push_back(fmt::format("speed {:.17g} rad/s of the grid is {}, participation {:.1e}", p.speed, what, *p.participation));
  }
  if (response.coverage.status != CoverageStatus::complete && !response.coverage.reason.empty())
    all.push_back("critical speeds are not certified complete: " + response.coverage.reason);
  return all;
}

std::vector<std::string> FrequencyReport::remarks() const {
  std::vector<std::string> all;
  for (const FrequencyPoint& p : response.points) {
    if (!p.participation || p.added || p.driven == Driven::no) continue;
    const char* what = p.resonance() ? "a resonance: the response is unbounded there"
                                     : "that of a mode, and whether the force drives it cannot be told: the limit from both sides is given";
    all.push_back(fmt::format("ω = {:.17g} rad/s of the grid is {}, participation {:.1e}", p.omega, what, *p.participation));
  }
  if (response.coverage && response.coverage->status != CoverageStatus::complete)
    all.push_back("the modes of the range are not certified complete: " + response.coverage->reason);
  return all;
}

void FrequencyReport::keep_only(const std::vector<Index>& chosen) {
  if (chosen.empty()) return;
  labels = labels_at(labels, chosen);
  for (FrequencyPoint& p : response.points) {
    if (p.q.size() > 0) p.q = ComplexVector(p.q(chosen));
  }
}

}  // namespace gyromode
