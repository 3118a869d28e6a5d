#pragma once

#include "gyromode/models/model_kind.h"

#include <functional>

namespace gyromode::io {

/// A model whose numbers are formulas of named parameters: with other values of these it is made again from its
/// document. Everything else is the model that it makes.
class ParametrisedModel : public ModelKind {
 public:
  /// What the document makes with other values of some parameters: all of them, as parameters may be formulas of
  /// others, and the model.
  struct Made {
    std::vector<Parameter> named;
    std::shared_ptr<const ModelKind> model;
  };
  using Maker = std::function<Made(const std::vector<ParameterValue>& values)>;

  /// `given`: what was given a value before, beside the document.
  ParametrisedModel(Maker maker, Made made, std::vector<ParameterValue> given = {})
      : maker_(std::move(maker)), named_(std::move(made.named)), made_(std::move(made.model)), given_(std::move(given)) {}

  Index size() const override { return made_->size(); }
  const Labels& labels() const override { return made_->labels(); }
  std::string_view in_words() const override { return made_->in_words(); }
  Labels massless() const override { return made_->massless(); }
  bool transcendental() const override { return made_->transcendental(); }
  bool finite() const override { return made_->finite(); }
  ModesResult modes(const ModesOptions& options) const override { return made_->modes(options); }
  CountResult count(const Window& window) const override { return made_->count(window); }
  ModesResult verdict(bool with_shapes, const Progress& progress) const override { return made_->verdict(with_shapes, progress); }
  StabilityReport stability(const Progress& progress) const override { return made_->stability(progress); }
  StructureReport structure(std::optional<double> at) const override { return made_->structure(at); }
  std::vector<std::string> doubts() const override { return made_->doubts(); }
  void require_motion() const override { made_->require_motion(); }
  ResponseReport response(const MotionRequest& request) const override { return made_->response(request); }
  FrequencyReport frequency_response(const FrequencyRequest& request) const override { return made_->frequency_response(request); }
  const System* second_order() const override { return made_->second_order(); }
  std::vector<NamedMatrix> matrices() const override { return made_->matrices(); }
  std::optional<IgnoredCouplings> left_out() const override { return made_->left_out(); }
  std::shared_ptr<const ModelKind> discretised(std::optional<Index> elements) const override { return made_->discretised(elements); }

  std::vector<Parameter> parameters() const override;
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;

 private:
  Maker maker_;
  std::vector<Parameter> named_;
  std::shared_ptr<const ModelKind> made_;
  std::vector<ParameterValue> given_;
  double tolerance_ = 0;  // of couplings left out
};

}  // namespace gyromode::io
