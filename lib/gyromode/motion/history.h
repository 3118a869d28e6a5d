#pragma once

#include "gyromode/motion/response.h"

namespace gyromode {

/// Of anything that has at(t). `progress` is told "times".
template <class Motion>
History history_of(const Motion& motion, Index coordinates, const Vector& times, const Progress& progress) {
  History h{times, Matrix(coordinates, times.size()), Matrix(coordinates, times.size())};
  for (Index k = 0; k < times.size(); ++k) {
    if (progress.stopped()) {
      h = {Vector(times.head(k)), Matrix(h.q.leftCols(k)), Matrix(h.qdot.leftCols(k)), true};
      break;
    }
    progress.report("times", k, times.size());
    const State w = motion.at(times(k));
    h.q.col(k) = w.q;
    h.qdot.col(k) = w.qdot;
  }
  return h;
}

}  // namespace gyromode
