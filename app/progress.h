#pragma once

#include "output.h"

#include "gyromode/base/progress.h"

#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace gyromode::app {

/// Where long work is, on stderr unless --quiet: on a terminal one line that is rewritten, for whatever takes over a
/// second, taken away in the end; elsewhere a line every five seconds. With --verbose a line a stage, with its time.
class ProgressLine {
 public:
  explicit ProgressLine(const OutputOption& output);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// What work tells, to be handed to it. From now on the first Ctrl-C (or SIGTERM) asks it to stop and to write what
  /// it has; the second ends the program. Verbs that do not ask for this end at the first.
  Progress progress();
  /// As Progress::tell.
  void tell(std::string_view what, Index done, Index all);

 private:
  using Clock = std::chrono::steady_clock;
  struct Stage {
    Clock::time_point since;
    Index done = 0, all = 0;
  };
  void rewrite();
  void end_stage();
  std::string words() const;

  const OutputOption& output_;
  const bool terminal_;
  const Clock::time_point start_;
  std::mutex mutex_;
  std::condition_variable done_condition_;
  bool done_ = false, written_ = false;
  Clock::time_point told_;
  std::string stage_;
  std::map<std::string, Stage, std::less<>> stages_;
  std::thread ticker_;
};

/// "12 s", "3 min", "2 h 10 min".
std::string duration_words(double seconds);

}  // namespace gyromode::app
