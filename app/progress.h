#pragma once

#include "output.h"

#include "gyromode/base/progress.h"

namespace gyromode::app {

/// A line on stderr every few seconds, unless --quiet. From now on the first Ctrl-C (or SIGTERM) asks work to stop and
/// to write what it has; the second ends the program. Verbs that do not ask for this end at the first.
Progress progress_on(const OutputOption& output);

}  // namespace gyromode::app
