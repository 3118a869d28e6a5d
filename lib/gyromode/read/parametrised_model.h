#pragma once

#include "gyromode/models/delegating_model.h"

#include <functional>

namespace gyromode::io {

/// A model whose numbers are formulas of named parameters: with other values of these it is made again from its
/// document. Everything else is the model that it makes.
class ParametrisedModel : public DelegatingModel {
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
      : DelegatingModel(std::move(made.model)), maker_(std::move(maker)), named_(std::move(made.named)), given_(std::move(given)) {}

  std::vector<Parameter> parameters() const override;
  std::optional<Parameter> parameter(std::string_view key) const override;
  std::shared_ptr<const ModelKind> with(const std::vector<ParameterValue>& values) const override;
  std::pair<std::shared_ptr<const ModelKind>, IgnoredCouplings> without_couplings(double tolerance) const override;

 private:
  Maker maker_;
  std::vector<Parameter> named_;
  std::vector<ParameterValue> given_;
  double tolerance_ = 0;  // of couplings left out
};

}  // namespace gyromode::io
