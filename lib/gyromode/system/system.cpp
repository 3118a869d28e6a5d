#include "gyromode/system/system.h"

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/system/diagnosis.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <utility>

namespace gyromode {

namespace {

void require_size(std::string_view name, const Matrix& a, Index n) {
  if (a.rows() != n)
    throw LawBroken(fmt::format("{} must have the order of M: it is {} × {}, M is {} × {}", name, a.rows(), a.cols(), n, n));
}

LawBroken explained(const LawBroken& e, const std::string& diagnosis) {
  return diagnosis.empty() ? e : LawBroken(fmt::format("{}; {}", e.what(), diagnosis));
}

}  // namespace

System::System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels, const Admission& admission)
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
  const auto admit = [&](std::string_view name, Matrix& a, int sign, auto&& diagnosis) {
    try {
      if (auto repair = made_symmetric(name, a, sign, admission)) repairs_.push_back(std::move(*repair));
    } catch (const LawBroken& e) {
      throw explained(e, diagnosis());
    }
  };
  admit("M", mass_, 1, [] { return ""; });
  admit("G", gyroscopic_, -1, [&] { return diagnosis_of_gyroscopic(mass_, gyroscopic_, stiffness_); });
  admit("K", stiffness_, 1, [&] { return diagnosis_of_stiffness(mass_, gyroscopic_, stiffness_); });
  try {
    require_positive_definite("M", mass_, labels_);
  } catch (const LawBroken& e) {
    throw explained(e, diagnosis_of_mass(mass_, stiffness_));
  }
}

System System::replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const {
  System s(std::move(mass), std::move(gyroscopic), std::move(stiffness), labels_);
  s.repairs_ = repairs_;
  return s;
}

ComplexMatrix System::impedance(double omega) const {
  ComplexMatrix h(size(), size());
  h.real() = stiffness_ - omega * omega * mass_;
  h.imag() = omega * gyroscopic_;
  return h;
}

}  // namespace gyromode
