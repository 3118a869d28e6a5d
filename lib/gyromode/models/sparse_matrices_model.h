#pragma once

#include "gyromode/models/model_kind.h"
#include "gyromode/sparse/sparse_system.h"

#include <memory>

namespace gyromode {

/// Large sparse M, G, K.
class SparseMatricesModel : public ModelKind {
 public:
  /// @throws LawBroken; TooLarge
  explicit SparseMatricesModel(SparseMatrices matrices) : system_(std::move(matrices)) {}

  const SparseSystem& system() const { return system_; }
  Index size() const override { return system_.size(); }
  const Labels& labels() const override { return system_.labels(); }
  std::string_view in_words() const override { return "sparse M, G, K"; }
  bool finite() const override { return false; }
  ModesResult modes(const ModesOptions& options) const override;
  CountResult count(const Window& window) const override;
  std::vector<PlannedFactorisation> plan() const override { return plan_of(system_); }
  StructureReport structure(std::optional<double> at) const override;
  void require_motion() const override {}
  /// In the modes of the window asked for.
  ResponseReport response(const MotionRequest& request) const override;
  /// By few factorisations: projected on the modes of the range where these are all, and corrected.
  FrequencyReport frequency_response(const FrequencyRequest& request) const override;
  std::vector<std::string> doubts(bool fixed_axes) const override;

 private:
  SparseSystem system_;
};

/// The model of matrices from files: dense up to 1000 coordinates where M is positive definite, else sparse. @throws
/// LawBroken; TooLarge
std::shared_ptr<const ModelKind> model_of_sparse(SparseMatrices matrices);

}  // namespace gyromode
