#pragma once

#include "gyromode/base/types.h"

#include <functional>
#include <string_view>

namespace gyromode {

/// How long work tells where it is, and how it is told to stop. Both may be left empty. `tell` and `stop` are called
/// from the thread that asked for the work, once a piece of it (a mode, a cell, a time): they should be quick.
///
/// Work that is stopped ends with what is known by then, marked as interrupted in its result; where nothing is known it
/// throws Interrupted.
struct Progress {
  /// `done` of `all` of what ("cells", "modes"); all = 0 where it is not known. 0 of 0: a stage that begins and has no
  /// parts ("error bounds")
  std::function<void(std::string_view what, Index done, Index all)> tell;
  std::function<bool()> stop;  ///< true: stop soon

  /// Tells, where anybody listens.
  void report(std::string_view what, Index done, Index all) const {
    if (tell) tell(what, done, all);
  }
  /// Tells that a stage begins which has no parts.
  void stage(std::string_view what) const { report(what, 0, 0); }
  bool stopped() const { return stop && stop(); }  ///< whether work should end
};

}  // namespace gyromode
