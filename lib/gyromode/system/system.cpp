#include "gyromode/system/system.h"

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <utility>

namespace gyromode {

namespace {

void require_size(std::string_view name, const Matrix& a, Index n) {
  if (a.rows() != n)
    throw LawBroken(fmt::format("{} must have the order of M: it is {} × {}, M is {} × {}", name, a.rows(), a.cols(), n, n));
}

}  // namespace

System::System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels)
    : mass_(std::move(mass)), gyroscopic_(std::move(gyroscopic)), stiffness_(std::move(stiffness)), labels_(std::move(labels)) {
  require_order("a model", mass_.rows());
  require_square("M", mass_);
  require_square("G", gyroscopic_);
  require_square("K", stiffness_);
  require_size("G", gyroscopic_, size());
  require_size("K", stiffness_, size());
  require_finite("M", mass_);
  require_finite("G", gyroscopic_);
  require_finite("K", stiffness_);
  if (labels_.empty()) labels_ = default_labels(size());
  require_labels(labels_, size());
  symmetry_errors_ = {require_symmetric("M", mass_), require_skew("G", gyroscopic_), require_symmetric("K", stiffness_)};
  mass_ = symmetric_part(mass_);
  gyroscopic_ = skew_part(gyroscopic_);
  stiffness_ = symmetric_part(stiffness_);
  require_positive_definite("M", mass_, labels_);
}

System System::replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const {
  System s(std::move(mass), std::move(gyroscopic), std::move(stiffness), labels_);
  s.symmetry_errors_ = symmetry_errors_;
  return s;
}

ComplexMatrix System::impedance(double omega) const {
  ComplexMatrix h(size(), size());
  h.real() = stiffness_ - omega * omega * mass_;
  h.imag() = omega * gyroscopic_;
  return h;
}

}  // namespace gyromode
