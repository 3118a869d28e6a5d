#include "progress.h"

#include <fmt/format.h>

#include <csignal>
#include <memory>

namespace gyromode::app {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void on_signal(int signal) {
  asked_to_stop = 1;
  std::signal(signal, SIG_DFL);
}

}  // namespace

void listen_to_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

bool interrupted() { return asked_to_stop != 0; }

Progress progress_on(const OutputOption& output) {
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
