#include "gyromode/system/first_order_system.h"

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <utility>

namespace gyromode {

FirstOrderSystem::FirstOrderSystem(Matrix inertia, Matrix gyroscopic, Labels labels, const Admission& admission)
    : inertia_(std::move(inertia)), gyroscopic_(std::move(gyroscopic)), labels_(std::move(labels)) {
  require_order("a model", inertia_.rows());
  require_square("I", inertia_);
  require_square("G", gyroscopic_);
  if (gyroscopic_.rows() != size()) {
    throw LawBroken::of("G", fmt::format("G must have the order of I: it is {0} × {0}, I is {1} × {1}", gyroscopic_.rows(), size()));
  }
  require_finite("I", inertia_);
  require_finite("G", gyroscopic_);
  if (labels_.empty()) labels_ = default_labels(size());
  require_labels(labels_, size());
  const auto admit = [&](std::string_view name, Matrix& a, int sign) {
    if (auto repair = made_symmetric(name, a, sign, admission)) repairs_.push_back(std::move(*repair));
  };
  admit("I", inertia_, 1);
  admit("G", gyroscopic_, -1);
  require_positive_definite("I", inertia_, labels_);
}

FirstOrderSystem FirstOrderSystem::replaced(Matrix inertia, Matrix gyroscopic) const {
  FirstOrderSystem s(std::move(inertia), std::move(gyroscopic), labels_);
  s.repairs_ = repairs_;
  return s;
}

ComplexMatrix FirstOrderSystem::impedance(double omega) const {
  ComplexMatrix h(size(), size());
  h.real() = omega * inertia_;
  h.imag() = -gyroscopic_;
  return h;
}

}  // namespace gyromode
