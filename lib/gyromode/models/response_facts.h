#pragma once

#include "gyromode/base/error.h"
#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

namespace gyromode {

/// What a motion `r` over times (not empty) reports of itself. Throws InvalidArgument where it grows beyond what
/// numbers hold.
template <class Motion>
void add_motion(const Motion& r, const MotionRequest& request, ResponseReport& report) {
  if (request.times.size() == 0) throw InvalidArgument("a motion over no times was asked for");
  report.history = r.at(request.times, request.progress);
  const Vector& times = report.history.t;
  if (times.size() == 0) throw Interrupted();
  report.rates = request.rates;
  report.modal = r.modal();
  report.departure = r.departure();
  report.phase_error = r.phase_error(times(times.size() - 1));
  for (Index k = 0; k < times.size(); ++k) {
    if (!report.history.q.col(k).allFinite())
      throw InvalidArgument(fmt::format("the motion grows beyond what numbers hold at t = {:g}: ask for less time", times(k)));
  }
}

/// That, and what the Response says that its energies are of.
template <class Motion>
void add_facts(const Motion& r, const Response& inner, const MotionRequest& request, ResponseReport& report) {
  add_motion(r, request, report);
  report.stability = inner.stability();
  report.initial_energy = inner.initial_energy();
  report.zero_energy = inner.zero_energy();
  report.remainder_energy = inner.remainder_energy();
  report.balance_closed = inner.balance_closed();
}

}  // namespace gyromode
