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
    throw LawBroken::of(name, fmt::format("{} must have the order of M: it is {} × {}, M is {} × {}", name, a.rows(), a.cols(), n, n));
}

LawBroken explained(const LawBroken& e, const std::string& diagnosis) {
  return diagnosis.empty() ? e : LawBroken::of(e.matrix(), fmt::format("{}; {}", e.what(), diagnosis));
}

}  // namespace

AdmittedMatrices admitted(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels, const Admission& admission) {
  AdmittedMatrices a{std::move(mass), std::move(gyroscopic), std::move(stiffness), std::move(labels), {}};
  require_order("a model", a.mass.rows());
  require_square("M", a.mass);
  require_square("G", a.gyroscopic);
  require_square("K", a.stiffness);
  const Index n = a.mass.rows();
  require_size("G", a.gyroscopic, n);
  require_size("K", a.stiffness, n);
  require_finite("M", a.mass);
  require_finite("G", a.gyroscopic);
  require_finite("K", a.stiffness);
  if (a.labels.empty()) a.labels = default_labels(n);
  require_labels(a.labels, n);
  const auto admit = [&](std::string_view name, Matrix& matrix, int sign, auto&& diagnosis) {
    try {
      if (auto repair = made_symmetric(name, matrix, sign, admission)) a.repairs.push_back(std::move(*repair));
    } catch (const LawBroken& e) {
      throw admission.strict && departs_by_rounding(matrix, sign) ? explained(e, "this is rounding, which is let in without --strict")
                                                                  : explained(e, diagnosis());
    }
  };
  admit("M", a.mass, 1, [&] { return diagnosis_of_mass(a.mass, a.stiffness); });
  admit("G", a.gyroscopic, -1, [&] { return diagnosis_of_gyroscopic(a.mass, a.gyroscopic, a.stiffness); });
  admit("K", a.stiffness, 1, [&] { return diagnosis_of_stiffness(a.mass, a.gyroscopic, a.stiffness); });
  return a;
}

System::System(Matrix mass, Matrix gyroscopic, Matrix stiffness, Labels labels, const Admission& admission)
    : System(admitted(std::move(mass), std::move(gyroscopic), std::move(stiffness), std::move(labels), admission)) {}

System::System(AdmittedMatrices matrices) : of_(std::move(matrices)) {
  try {
    require_positive_definite("M", mass(), labels());
  } catch (const LawBroken& e) {
    throw explained(e, diagnosis_of_mass(mass(), stiffness()));
  }
}

System System::replaced(Matrix mass, Matrix gyroscopic, Matrix stiffness) const {
  System s(std::move(mass), std::move(gyroscopic), std::move(stiffness), labels());
  s.of_.repairs = of_.repairs;
  return s;
}

ComplexMatrix System::impedance(double omega) const {
  ComplexMatrix h(size(), size());
  h.real() = stiffness() - omega * omega * mass();
  h.imag() = omega * gyroscopic();
  return h;
}

}  // namespace gyromode
