#include "gyromode/modes/shape.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// The first of those that are as large as the largest, by |z|² unless that leaves the range of double.
Index position_of_largest(const ComplexVector& x) {
  if (x.size() == 0) return 0;
  constexpr double tie = 1e-12;
  const double part = std::max(x.real().cwiseAbs().maxCoeff(), x.imag().cwiseAbs().maxCoeff());
  const bool squares = part > 1e-140 && part < 1e140;
  const Vector size = squares ? Vector(x.cwiseAbs2()) : Vector(x.cwiseAbs());
  const double least = (1 - (squares ? 2 : 1) * tie) * size.maxCoeff();
  Index at = 0;
  while (size(at) < least) ++at;
  return at;
}

}  // namespace

Complex largest_entry(const ComplexVector& x) { return x(position_of_largest(x)); }

ComplexVector normalised(ComplexVector x) {
  const Index at = position_of_largest(x);
  const Complex pivot = x(at);
  if (!(std::abs(pivot) > 0)) return x;
  // Dividing by a real or an imaginary number must not mix the parts.
  if (pivot.imag() == 0) {
    x /= pivot.real();
  } else if (pivot.real() == 0) {
    for (Complex& z : x) z = Complex(z.imag() / pivot.imag(), -z.real() / pivot.imag());
  } else {
    x /= pivot;
  }
  x(at) = 1;
  for (Complex& z : x) z = Complex(z.real() + 0.0, z.imag() + 0.0);  // −0 becomes 0
  return x;
}

}  // namespace gyromode
