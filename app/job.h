#pragma once

#include "input.h"
#include "output.h"
#include "progress.h"

#include "gyromode/write/document.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace gyromode::app {

/// What every verb on a model does: read it, ask it, and know how long each took.
class Job {
 public:
  Job(const ModelSource& source, const OutputOption& output)
      : output_(output), model_((output.require_place(source.files()), source.read())) {
    timings_.read = watch_.lap();
    if (model_.size() >= worth_a_word) output.say(fmt::format("{} coordinates read in {:.2g} s; solving", model_.size(), timings_.read));
    if (model_.ignored) output.say(in_words(*model_.ignored));
  }

  const Model& model() const { return model_; }
  /// Puts another body in the place of the model's: its approximation.
  void replace(std::shared_ptr<const ModelKind> body) { model_.body = std::move(body); }
  const Timings& timings() const { return timings_; }
  Progress progress() const { return progress_on(output_); }
  /// Says that the result written is a part.
  ExitCode interrupted() const {
    output_.say("interrupted: what was known by then is written");
    return ExitCode::interrupted;
  }

  /// What the question finds; its time counts as solving.
  template <class Question>
  auto answer(Question&& question) {
    auto result = question(std::as_const(model_));
    timings_.solve = watch_.lap();
    return result;
  }

 private:
  static constexpr Index worth_a_word = 1000;  // from here on a solve takes seconds

  const OutputOption& output_;
  Stopwatch watch_;
  Model model_;
  Timings timings_;
};

}  // namespace gyromode::app
