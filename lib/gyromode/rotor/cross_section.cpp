#include "gyromode/rotor/cross_section.h"

#include <numbers>

namespace gyromode {

namespace {
constexpr double pi = std::numbers::pi;
}

double CrossSection::area() const { return pi / 4 * (outer - inner) * (outer + inner); }

double CrossSection::second_moment() const { return pi / 64 * (outer - inner) * (outer + inner) * (outer * outer + inner * inner); }

double CrossSection::shear_coefficient(double poisson) const {
  const double m2 = (inner / outer) * (inner / outer), ring = (1 + m2) * (1 + m2);
  return 6 * (1 + poisson) * ring / ((7 + 6 * poisson) * ring + (20 + 12 * poisson) * m2);
}

}  // namespace gyromode
