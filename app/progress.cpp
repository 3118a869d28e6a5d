#include "progress.h"

#include <fmt/format.h>

#include <csignal>
#include <memory>

namespace gyromode::app {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void on_signal(int) {
  asked_to_stop = 1;
  for (const int s : {SIGINT, SIGTERM}) std::signal(s, SIG_DFL);
}

// The first Ctrl-C (or SIGTERM) asks work to stop and to write what it has; the second ends the program. What ignores
// signals, as under nohup, goes on ignoring them.
void listen_to_interrupts() {
  for (const int s : {SIGINT, SIGTERM}) {
    if (std::signal(s, on_signal) == SIG_IGN) std::signal(s, SIG_IGN);
  }
}

bool interrupted() { return asked_to_stop != 0; }

}  // namespace

Progress progress_on(const OutputOption& output) {
  listen_to_interrupts();
  constexpr double seconds_between_words = 5;
  const auto tell = [&output, since = std::make_shared<Stopwatch>(), quiet = 0.0](std::string_view what, Index done, Index all) mutable {
    quiet += since->lap();
    if (quiet < seconds_between_words) return;
    quiet = 0;
    output.say(all > 0 ? fmt::format("{} of {} {}", done, all, what) : fmt::format("{} {}", done, what));
  };
  return {tell, interrupted};
}

}  // namespace gyromode::app
