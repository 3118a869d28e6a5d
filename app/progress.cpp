#include "progress.h"

#include "gyromode/base/lines.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>

#include <unistd.h>

namespace gyromode::app {

namespace {

volatile std::sig_atomic_t asked_to_stop = 0;

extern "C" void on_signal(int) {
  asked_to_stop = 1;
  for (const int s : {SIGINT, SIGTERM}) std::signal(s, SIG_DFL);
}

// What ignores signals, as under nohup, goes on ignoring them.
void listen_to_interrupts() {
  for (const int s : {SIGINT, SIGTERM}) {
    if (std::signal(s, on_signal) == SIG_IGN) std::signal(s, SIG_IGN);
  }
}

bool interrupted() { return asked_to_stop != 0; }

constexpr std::chrono::milliseconds between_rewrites(200);
constexpr std::chrono::seconds before_first(1), between_lines(5);

double seconds(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

}  // namespace

std::string duration_words(double seconds) {
  const auto whole = static_cast<long long>(seconds + 0.5);
  if (whole < 90) return fmt::format("{} s", whole);
  if (whole < 90 * 60) return fmt::format("{} min", (whole + 30) / 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

ProgressLine::ProgressLine(const OutputOption& output)
    : output_(output), terminal_(!output.quiet && !output.verbose && isatty(STDERR_FILENO) == 1), start_(Clock::now()), told_(start_) {
  if (!terminal_) return;
  ticker_ = std::thread([this] {
    std::unique_lock lock(mutex_);
    while (!done_condition_.wait_for(lock, between_rewrites, [this] { return done_; })) rewrite();
  });
}

ProgressLine::~ProgressLine() {
  if (ticker_.joinable()) {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    done_condition_.notify_all();
    ticker_.join();
    if (written_) std::fputs("\r\033[K", stderr);
  }
  end_stage();
}

Progress ProgressLine::progress() {
  listen_to_interrupts();
  return {[this](std::string_view what, Index done, Index all) { tell(what, done, all); }, interrupted};
}

// A stage may be left and come back, as the cells of a map do row by row: its time counts from its beginning.
void ProgressLine::tell(std::string_view what, Index done, Index all) {
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (stage_ != what) {
    end_stage();
    stage_ = what;
    stages_.try_emplace(stage_, Stage{now});
  }
  Stage& stage = stages_.find(stage_)->second;
  stage.done = done;
  stage.all = all;
  if (terminal_ || output_.verbose || now - told_ < between_lines) return;
  told_ = now;
  output_.say(words());
}

// "modes: 120 of 900 (13 %), about 12 s left"; without an end in sight the time that has gone.
std::string ProgressLine::words() const {
  const auto at = stages_.find(stage_);
  if (at == stages_.end()) return fmt::format("working, {}", duration_words(seconds(Clock::now() - start_)));
  const Stage& stage = at->second;
  const double gone = seconds(Clock::now() - stage.since);
  if (stage.all <= 0 || stage.done > stage.all)
    return stage.done > 0 ? fmt::format("{}: {}, {}", stage_, stage.done, duration_words(gone))
                          : fmt::format("{}, {}", stage_, duration_words(gone));
  const double fraction = static_cast<double>(stage.done) / static_cast<double>(stage.all);
  std::string text = fmt::format("{}: {} of {} ({:.0f} %)", stage_, stage.done, stage.all, 100 * fraction);
  if (stage.done > 0) text += fmt::format(", about {} left", duration_words(gone * (1 - fraction) / fraction));
  return text;
}

void ProgressLine::rewrite() {
  if (Clock::now() - start_ < before_first) return;
  fmt::print(stderr, "\r\033[K{}", wrapped("gyromode: " + words(), line_columns - 1).front());
  std::fflush(stderr);
  written_ = true;
}

void ProgressLine::end_stage() {
  if (!output_.verbose || stage_.empty()) return;
  const Stage& stage = stages_.find(stage_)->second;
  const std::string count = stage.done > 0 ? fmt::format(" ({})", stage.done) : "";
  output_.say(fmt::format("{}{}: {:.3g} s", stage_, count, seconds(Clock::now() - stage.since)));
}

}  // namespace gyromode::app
