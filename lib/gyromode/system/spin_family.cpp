#include "gyromode/system/spin_family.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

namespace gyromode {

namespace {

void require_order_of(std::string_view name, const Matrix& part, const Matrix& whole) {
  if (part.size() == 0 || (part.rows() == whole.rows() && part.cols() == whole.cols())) return;
  throw LawBroken(fmt::format("{} must have the order of the part at rest: it is {} × {}, that is {} × {}", name, part.rows(), part.cols(),
                              whole.rows(), whole.cols()));
}

}  // namespace

SpinFamily::Sum SpinFamily::sum(double spin) const {
  require_order_of("the part of G per spin", gyroscopic_per_spin, gyroscopic);
  require_order_of("the part of K per spin²", stiffness_per_spin2, stiffness);
  Matrix g = gyroscopic, k = stiffness;
  if (gyroscopic_per_spin.size() > 0) g += spin * gyroscopic_per_spin;
  if (stiffness_per_spin2.size() > 0) k += spin * spin * stiffness_per_spin2;
  return {std::move(g), std::move(k)};
}

System SpinFamily::at(double spin) const {
  Sum s = sum(spin);
  return System(mass, std::move(s.gyroscopic), std::move(s.stiffness), labels, admission);
}

}  // namespace gyromode
