#pragma once

#include "output.h"

#include "gyromode/base/progress.h"

namespace gyromode::app {

/// From now on the first Ctrl-C (or SIGTERM) asks work to stop and to write what it has; the second ends the program.
void listen_to_interrupts();
bool interrupted();

/// A line on stderr every few seconds, unless --quiet; stopped by an interrupt.
Progress progress_on(const OutputOption& output);

}  // namespace gyromode::app
