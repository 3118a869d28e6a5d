#pragma once

#include "input.h"
#include "output.h"
#include "progress.h"
#include "start_again.h"

#include "gyromode/write/document.h"

#include <fmt/format.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace gyromode::app {

/// What every verb on a model does: read it, ask it, and know how long each took.
class Job {
 public:
  Job(const ModelSource& source, const OutputOption& output) : output_(output), model_(read(source, output)) {
    timings_.read = watch_.lap();
    if (output.verbose) output.say(fmt::format("{}: {} coordinates read in {:.3g} s", model_.title, model_.size(), timings_.read));
    for (const std::string& doubt : model_.doubts()) output.say("remark: " + doubt);
    if (model_.ignored) output.say(in_words(*model_.ignored));
  }

  const Model& model() const { return model_; }
  /// Puts another body in the place of the model's: its approximation.
  void replace(std::shared_ptr<const ModelKind> body) { model_.body = std::move(body); }
  const Timings& timings() const { return timings_; }
  /// Says that the result written is a part.
  ExitCode interrupted() const {
    output_.say("interrupted: what was known by then is written");
    return ExitCode::interrupted;
  }

  /// What question(model, progress), or question(model), finds; its time counts as solving.
  template <class Question>
  auto answer(Question&& question) {
    ProgressLine line(output_);
    auto result = [&] {
      if constexpr (std::is_invocable_v<Question, const Model&, const Progress&>)
        return question(std::as_const(model_), line.progress());
      else
        return question(std::as_const(model_));
    }();
    timings_.solve = watch_.lap();
    return result;
  }

 private:
  static Model read(const ModelSource& source, const OutputOption& output) {
    output.require_place(source.files());
    start_again_for_large(source.files());
    ProgressLine line(output);
    line.tell("reading", 0, 0);
    return source.read();
  }

  const OutputOption& output_;
  Stopwatch watch_;
  Model model_;
  Timings timings_;
};

}  // namespace gyromode::app
