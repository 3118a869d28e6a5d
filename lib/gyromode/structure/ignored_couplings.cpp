#include "gyromode/structure/ignored_couplings.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace gyromode {

namespace {

void require(double tolerance) {
  if (!(tolerance >= 0 && tolerance <= 1))
    throw InvalidArgument(fmt::format("coupling tolerance: {:g} where a fraction from 0 to 1 was expected", tolerance));
}

double largest_entry(const Matrix& a) { return a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff(); }

Matrix thresholded(const Matrix& a, double tolerance) {
  Matrix b = (a.cwiseAbs().array() <= tolerance * largest_entry(a)).select(0.0, a);
  b.diagonal() = a.diagonal();
  return b;
}

// The largest relative entry that thresholded() makes zero.
IgnoredCouplings left_out(std::initializer_list<const Matrix*> matrices, double tolerance) {
  require(tolerance);
  IgnoredCouplings all{tolerance, 0};
  for (const Matrix* a : matrices) {
    if (const double most = largest_entry(*a); most > 0)
      all.largest = std::max(all.largest, largest_entry(*a - thresholded(*a, tolerance)) / most);
  }
  return all;
}

// Sums of what is left may lack what made them positive.
template <class Make>
auto keeping_laws(double tolerance, Make&& make) {
  try {
    return make();
  } catch (const LawBroken& e) {
    throw LawBroken(fmt::format("with couplings up to {:.2g} of the largest entry left out, {}: a smaller tolerance was expected",
                                tolerance, e.what()));
  }
}

}  // namespace

System without_ignored_couplings(const System& s, double tolerance) {
  require(tolerance);
  if (tolerance == 0) return s;
  return keeping_laws(tolerance, [&] {
    return s.replaced(thresholded(s.mass(), tolerance), thresholded(s.gyroscopic(), tolerance), thresholded(s.stiffness(), tolerance));
  });
}

FirstOrderSystem without_ignored_couplings(const FirstOrderSystem& s, double tolerance) {
  require(tolerance);
  if (tolerance == 0) return s;
  return keeping_laws(tolerance, [&] { return s.replaced(thresholded(s.inertia(), tolerance), thresholded(s.gyroscopic(), tolerance)); });
}

IgnoredCouplings ignored_couplings(const System& s, double tolerance) {
  return left_out({&s.mass(), &s.gyroscopic(), &s.stiffness()}, tolerance);
}
IgnoredCouplings ignored_couplings(const FirstOrderSystem& s, double tolerance) {
  return left_out({&s.inertia(), &s.gyroscopic()}, tolerance);
}

std::string in_words(const IgnoredCouplings& i) {
  if (i.largest == 0)
    return fmt::format("no coupling is as small as {:.2g} of the largest entry of its matrix: none is left out", i.tolerance);
  return fmt::format("couplings up to {:.2g} of the largest entry of their matrix are left out, as asked: the largest of them is {:.2g}",
                     i.tolerance, i.largest);
}

}  // namespace gyromode
