#pragma once

#include "gyromode/modes/components.h"

namespace gyromode {

/// The frequencies of a solved system with their errors, merged over the components and sorted: what windows are cut from.
struct Frequencies {
  struct Entry {
    double omega = 0;
    double error = 0;      ///< where the true root may be: omega ± error
    int energy_sign = 1;
    Index component = 0;
    Index position = 0;    ///< in the component's Spectrum; −1 − k for its k-th zero mode
  };
  std::vector<Entry> entries;

  explicit Frequencies(const SolvedSystem& s);
};

struct WindowEnds;

/// The count of modes in the window of `ends` by theory (T9), (T10), independent of the modes found but for their energy signs, and checked inside the window:
/// between runs of modes of one sign, and at the widest gaps, n₋(H) must have changed by the signs found below.
Coverage coverage(const SolvedSystem& s, const Frequencies& f, const Window& requested, const WindowEnds& ends);

}  // namespace gyromode
