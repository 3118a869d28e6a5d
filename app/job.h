#pragma once

#include "input.h"
#include "output.h"

#include "gyromode/io/document.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

namespace gyromode::app {

/// What every verb on a model does: read it, work on it, and know how long each took.
class Job {
 public:
  Job(const ModelSource& source, const OutputOption& output) : model_(source.read()) {
    timings_.read = watch_.lap();
    if (model_.size() >= worth_a_word) output.say(fmt::format("{} coordinates read in {:.2g} s; solving", model_.size(), timings_.read));
    if (model_.ignored) output.say(in_words(*model_.ignored));
  }

  const io::Model& model() const { return model_; }
  /// Puts another system in the place of the model's: its approximation.
  void replace(System system) { model_.system = std::move(system); }
  const io::Timings& timings() const { return timings_; }

  /// The result of `work` on the system, second or first order; its time counts as solving.
  template <class Work>
  auto solve(Work&& work) {
    auto result = std::visit(std::forward<Work>(work), model_.system);
    timings_.solve = watch_.lap();
    return result;
  }

 private:
  static constexpr Index worth_a_word = 1000;  // from here on a solve takes seconds

  Stopwatch watch_;
  io::Model model_;
  io::Timings timings_;
};

}  // namespace gyromode::app
