#include "gyromode/rotor/exact_shaft.h"

#include "gyromode/base/error.h"
#include "gyromode/rotor/cross_section.h"

#include <Eigen/LU>

#include <cmath>

namespace gyromode {

ExactPiece ExactPiece::of(const ShaftSection& s, const Material& m, double length, double speed, double tension) {
  if (s.theory != ShaftTheory::rayleigh) throw NotApplicable("exact shafts are of the theory 'rayleigh'");
  if (s.outer_diameter[0] != s.outer_diameter[1] || s.inner_diameter[0] != s.inner_diameter[1])
    throw NotApplicable("exact shafts have one diameter in each section: this one is tapered");
  const CrossSection c{s.outer_diameter[0], s.inner_diameter[0]};
  return {length, m.young * c.second_moment(), m.density * c.second_moment(), m.density * c.area(), tension, speed};
}

// With lengths in l and forces in EI/l²: Z⁗ + αZ″ − βZ = 0, or for the state (Z, Z′, Z″, t = Z‴ + αZ′)
//     Z′ = p,  p′ = m,  m′ = t − αp,  t′ = βZ.
// The forces on the ends are (t, −m) at the first and (−t, m) at the second.
template <class T>
Eigen::Matrix<T, 4, 4> ExactPiece::dynamic_stiffness(const T& omega) const {
  constexpr int most_terms = 80;
  const double l2 = length * length / bending;
  const T alpha = l2 * (rotary * omega * (omega - 2 * speed) - tension), beta = l2 * length * length * line_density * omega * omega;
  Eigen::Matrix<T, 4, 4> a = Eigen::Matrix<T, 4, 4>::Zero();
  a(0, 1) = a(1, 2) = a(2, 3) = T(1);
  a(2, 1) = -alpha;
  a(3, 0) = beta;
  Eigen::Matrix<T, 4, 4> transfer = Eigen::Matrix<T, 4, 4>::Identity(), term = transfer;
  for (int k = 1; k < most_terms; ++k) {
    term = (a * term / T(k)).eval();
    transfer += term;
  }
  using Half = Eigen::Matrix<T, 2, 2>;
  const Half t11 = transfer.template topLeftCorner<2, 2>(), t12 = transfer.template topRightCorner<2, 2>(),
             t21 = transfer.template bottomLeftCorner<2, 2>(), t22 = transfer.template bottomRightCorner<2, 2>();
  const Half by_second = t12.inverse(), by_first = -by_second * t11;  // (m, t) at the first end
  const Half end_first = t21 + t22 * by_first, end_second = t22 * by_second;
  Eigen::Matrix<T, 4, 4> d;
  d << by_first(1, 0), by_first(1, 1), by_second(1, 0), by_second(1, 1),         //
      -by_first(0, 0), -by_first(0, 1), -by_second(0, 0), -by_second(0, 1),      //
      -end_first(1, 0), -end_first(1, 1), -end_second(1, 0), -end_second(1, 1),  //
      end_first(0, 0), end_first(0, 1), end_second(0, 0), end_second(0, 1);
  const Eigen::Vector4d scale(1, length, 1, length);
  const double unit = bending / (length * length * length);
  for (int i = 0; i < 4; ++i) {
    for (int k = 0; k < 4; ++k) d(i, k) *= unit * scale(i) * scale(k);
  }
  return T(0.5) * (d + d.transpose().eval());
}

template Eigen::Matrix<double, 4, 4> ExactPiece::dynamic_stiffness(const double&) const;
template Eigen::Matrix<Complex, 4, 4> ExactPiece::dynamic_stiffness(const Complex&) const;

bool ExactPiece::clamped_above(double omega) const {
  constexpr double most = 3;
  const double a = rotary * omega * (omega + 2 * std::abs(speed)) - tension, b = line_density * omega * omega;
  const double square = (a + std::sqrt(a * a + 4 * b * bending)) / (2 * bending);
  return square * length * length <= most * most;
}

}  // namespace gyromode
