#include "gyromode/certificate/products.h"

#include "gyromode/lapack/multiply.h"

#include <cmath>

namespace gyromode {

namespace {

// Xᴴ A X for a product AX.
double form_of(const dense::Spectrum& s, const Matrix& re, const Matrix& im, Index i) { return s.re.col(i).dot(re.col(i)) + s.im.col(i).dot(im.col(i)); }

}  // namespace

Products products(const Impedance& h, const dense::Spectrum& s) {
  Products p;
  p.m_re = lapack::multiply(h.mass_rr(), s.re);
  p.m_im = lapack::multiply(h.mass_ii(), s.im);
  p.g_re = Matrix(h.gyroscopic_ri().rows(), s.im.cols());
  p.g_im = Matrix(h.gyroscopic_ri().cols(), s.re.cols());
  lapack::multiply_into(p.g_re, -1, h.gyroscopic_ri(), false, s.im, false, 0);
  lapack::multiply_into(p.g_im, -1, h.gyroscopic_ri(), true, s.re, false, 0);
  if (h.second_order()) {
    p.k_re = lapack::multiply(h.stiffness_rr(), s.re);
    p.k_im = lapack::multiply(h.stiffness_ii(), s.im);
  }
  for (Index i = 0; i < s.omega.size(); ++i) {
    p.functionals.push_back({form_of(s, p.m_re, p.m_im, i), form_of(s, p.g_re, p.g_im, i), h.second_order() ? form_of(s, p.k_re, p.k_im, i) : 0, h.second_order()});
  }
  return p;
}

double Functional::corrected(double omega) const {
  if (!second_order) return g / m;
  for (int step = 0; step < 3; ++step) {
    const double next = omega + value(omega) / slope(omega);
    if (!(std::abs(next - omega) <= 1e-3 * omega) || !(std::abs(value(next)) < std::abs(value(omega)))) break;
    omega = next;
  }
  return omega;
}

}  // namespace gyromode
