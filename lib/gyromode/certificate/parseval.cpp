#include "gyromode/certificate/parseval.h"

#include "gyromode/lapack/multiply.h"

#include <cmath>
#include <random>

namespace gyromode {

namespace {

// Always the same numbers, by their own formula: what the standard library's distributions give differs between libraries.
Vector random_signs_and_sizes(Index n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  Vector v(n);
  for (double& entry : v) entry = std::ldexp(static_cast<double>(generator() >> 11), -52) - 1;  // uniform in [−1, 1)
  return v;
}

// Rows of a vector that carry real and imaginary parts: all of both without a partition.
struct Parts {
  Vector re, im;
  Parts(const Impedance& h, const Vector& v) : re(h.quadrature() ? Vector(v.head(h.mass_rr().rows())) : v), im(h.quadrature() ? Vector(v.tail(h.mass_ii().rows())) : v) {}
};

double quadratic(const Matrix& a, const Vector& v) {
  Vector product = Vector::Zero(a.rows());
  lapack::multiply_add(product, 1, a, false, v);
  return v.dot(product);
}

// vᵀAv of A = A_rr, or diag(A_rr, A_ii).
double energy(const Impedance& h, const Matrix& rr, const Matrix& ii, const Parts& v) { return quadratic(rr, v.re) + (h.quadrature() ? quadratic(ii, v.im) : 0); }

// |Xᴴ A v|² of all modes, from AX.
Vector squares(const Matrix& re, const Matrix& im, const Parts& v) {
  Vector real = Vector::Zero(re.cols()), imaginary = Vector::Zero(im.cols());
  lapack::multiply_add(real, 1, re, true, v.re);
  lapack::multiply_add(imaginary, 1, im, true, v.im);
  return real.cwiseAbs2() + imaginary.cwiseAbs2();
}

}  // namespace

bool no_mode_twice(const Impedance& h, const dense::Spectrum& s, const Products& p) {
  constexpr double noticed = 1e-3;
  const Index n = h.size();
  if (!h.second_order() || s.stiffness_negative > 0 || s.stiffness_zero > 0 || s.omega.size() != n) return false;
  const Parts a(h, random_signs_and_sizes(n, 1979)), b(h, random_signs_and_sizes(n, 2026));
  Vector norms(n);
  for (Index i = 0; i < n; ++i) {
    const Functional f = functional(h, s, p, i);
    norms(i) = f.k + s.omega(i) * s.omega(i) * f.m;
  }
  const Vector by_displacement = 2 * squares(p.k_re, p.k_im, a).cwiseQuotient(norms);
  const Vector by_velocity = 2 * squares(p.m_re, p.m_im, b).cwiseProduct(s.omega.cwiseAbs2()).cwiseQuotient(norms);
  const double displacement_open = std::abs(by_displacement.sum() - energy(h, h.stiffness_rr(), h.stiffness_ii(), a));
  const double velocity_open = std::abs(by_velocity.sum() - energy(h, h.mass_rr(), h.mass_ii(), b));
  for (Index i = 0; i < n; ++i) {
    if (!(displacement_open <= noticed * by_displacement(i)) && !(velocity_open <= noticed * by_velocity(i))) return false;
  }
  return true;
}

}  // namespace gyromode
