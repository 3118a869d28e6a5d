#include "gyromode/certificate/measure.h"

#include "gyromode/base/rounding.h"
#include "gyromode/certificate/measure_unstable.h"
#include "gyromode/certificate/parseval.h"
#include "gyromode/certificate/products.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode {

namespace {

// r = H(ω)X, real and imaginary parts of the rows that each has.
struct ResidualVector {
  Vector re, im;
};
ResidualVector residual_of(const Impedance& h, const Products& p, double omega, Index i) {
  if (!h.second_order()) return {omega * p.m_re.col(i) - p.g_re.col(i), omega * p.m_im.col(i) - p.g_im.col(i)};
  const double w2 = omega * omega;
  return {p.k_re.col(i) - w2 * p.m_re.col(i) + omega * p.g_re.col(i), p.k_im.col(i) - w2 * p.m_im.col(i) + omega * p.g_im.col(i)};
}

// |z_i|² of every row of a vector given by the real and imaginary parts of its rows: one each with a partition, both
// without.
Vector squares(const Impedance& h, const Eigen::Ref<const Vector>& re, const Eigen::Ref<const Vector>& im) {
  if (!h.quadrature()) return re.cwiseAbs2() + im.cwiseAbs2();
  Vector all(re.size() + im.size());
  all << re.cwiseAbs2(), im.cwiseAbs2();
  return all;
}

ComplexVector whole(const Impedance& h, const Vector& re, const Vector& im) {
  ComplexVector z = ComplexVector::Zero(h.size());
  z.head(re.size()).real() = re;
  z.tail(im.size()).imag() = im;
  return z;
}

// c of the error bounds: what c roundings of the terms, as good as independent, add up to.
double roundings(Index n) { return (2 + std::sqrt(static_cast<double>(n))) * epsilon; }

// X_iᴴ(2ωM − jG)X_k (X_iᴴIX_k in first order).
Complex form_between(const Impedance& h, const Spectrum& s, const Products& p, Index i, Index k, double omega) {
  const auto image = [&](const Matrix& m, const Matrix& g) -> Vector {
    return h.second_order() ? Vector(2 * omega * m.col(k) - g.col(k)) : Vector(m.col(k));
  };
  const Vector re = image(p.m_re, p.g_re), im = image(p.m_im, p.g_im);
  const double real = s.re.col(i).dot(re) + s.im.col(i).dot(im);
  return h.quadrature() ? Complex(real, 0) : Complex(real, s.re.col(i).dot(im) - s.im.col(i).dot(re));
}

// Runs of roots, in order of frequency, whose intervals overlap. own_scale and own_error are those of unit shapes.
void bound_clusters(const Impedance& h, const Spectrum& s, const Products& p, const Vector& own_scale, const Vector& own_error,
                    Assessment& a) {
  constexpr Index most = 64;  // a larger run is no cluster but a spectrum that rounding cannot resolve: the single bounds stand
  const Vector single = a.error_bound;
  for (Index first = 0, last; first < s.omega.size(); first = last + 1) {
    last = first;
    while (last + 1 < s.omega.size() && s.omega(last + 1) - s.omega(last) <= single(last) + single(last + 1)) ++last;
    const Index count = last - first + 1;
    if (count == 1 || count > most) continue;
    ComplexMatrix gram(count, count);
    double error2 = 0;
    for (Index i = 0; i < count; ++i) {
      const Index at = first + i;
      error2 += std::pow(own_error(at) / own_scale(at), 2);
      for (Index k = 0; k < count; ++k)
        gram(i, k) = form_between(h, s, p, at, first + k, s.omega(at)) / std::sqrt(own_scale(at) * own_scale(first + k));
    }
    const double bound = std::sqrt(error2) / small::singular_values(gram).minCoeff();
    for (Index i = first; i <= last; ++i) {
      a.error_bound(i) = std::max(single(i), bound);
      a.cluster[static_cast<std::size_t>(i)] = count;
    }
  }
}

Assessment measured(const Impedance& h, const Spectrum& s, const Products& p) {
  const Index m = s.omega.size();
  Assessment a{Vector(m), Vector(m), Vector(m), Vector(m), Vector(m), std::vector<Index>(static_cast<std::size_t>(m), 1), false, {}};
  Vector own_scale(m), own_error(m);
  for (Index i = 0; i < m; ++i) {
    const double omega = s.omega(i);
    const ResidualVector r = residual_of(h, p, omega, i);
    const Vector r2 = squares(h, r.re, r.im), x2 = squares(h, s.re.col(i), s.im.col(i));
    const Vector weight = h.weight(omega);
    const double form = p.functional(i).slope(omega);
    own_scale(i) = weight.dot(x2);
    own_error(i) = (r2.cwiseProduct(x2)).cwiseSqrt().sum() + roundings(h.size()) * h.rounding_weight(omega).dot(x2);
    a.residual(i) = h.given_residual(whole(h, r.re, r.im), s.shape(i), omega);
    a.own_residual(i) = std::sqrt((weight.array() > 0).select(r2.cwiseQuotient(weight), 0).sum() / own_scale(i));
    a.form(i) = form / x2.sum();
    a.sensitivity(i) = own_scale(i) / std::abs(form);
    a.error_bound(i) = own_error(i) / std::abs(form);
  }
  a.no_root_twice = no_root_twice(h, s, p);
  bound_clusters(h, s, p, own_scale, own_error, a);
  return a;
}

}  // namespace

Assessment measure(const Impedance& h, const Spectrum& s, const Products& p, const CharacteristicProducts& of_unstable) {
  Assessment a = measured(h, s, p);
  a.unstable = measure_unstable(h, s.unstable, of_unstable);
  return a;
}

Assessment measure(const Impedance& h, const Spectrum& s) {
  return measure(h, s, products(h, s), h.characteristic_products(s.unstable.right));
}

}  // namespace gyromode
