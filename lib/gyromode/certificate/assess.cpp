#include "gyromode/certificate/assess.h"

#include "gyromode/base/rounding.h"
#include "gyromode/certificate/assess_unstable.h"
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

// |z_i|² of every row of a vector given by the real and imaginary parts of its rows: one each with a partition, both without.
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

std::vector<Index> chosen(const std::vector<Index>& v, const std::vector<Index>& order) {
  std::vector<Index> sorted;
  for (const Index i : order) sorted.push_back(v[static_cast<std::size_t>(i)]);
  return sorted;
}

void sort_by_frequency(dense::Spectrum& s, Assessment& a) {
  const Index m = s.omega.size();
  if (std::is_sorted(s.omega.begin(), s.omega.end())) return;
  std::vector<Index> order(static_cast<std::size_t>(m));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index k) { return s.omega(i) < s.omega(k); });
  a.cluster = chosen(a.cluster, order);
  for (Vector* v : {&s.omega, &a.residual, &a.own_residual, &a.form, &a.error_bound, &a.sensitivity}) *v = Vector((*v)(order));
  s.re = Matrix(s.re(Eigen::all, order));
  s.im = Matrix(s.im(Eigen::all, order));
}

// X_iᴴ(2ωM − jG)X_k (X_iᴴIX_k in first order).
Complex form_between(const Impedance& h, const dense::Spectrum& s, const Products& p, Index i, Index k, double omega) {
  const auto image = [&](const Matrix& m, const Matrix& g) -> Vector { return h.second_order() ? Vector(2 * omega * m.col(k) - g.col(k)) : Vector(m.col(k)); };
  const Vector re = image(p.m_re, p.g_re), im = image(p.m_im, p.g_im);
  const double real = s.re.col(i).dot(re) + s.im.col(i).dot(im);
  return h.quadrature() ? Complex(real, 0) : Complex(real, s.re.col(i).dot(im) - s.im.col(i).dot(re));
}

// Runs of roots, in order of frequency, whose intervals overlap. own_scale and own_error are those of unit shapes.
void bound_clusters(const Impedance& h, const dense::Spectrum& s, const Products& p, const Vector& own_scale, const Vector& own_error, Assessment& a) {
  constexpr std::size_t most = 64;  // a larger run is no cluster but a spectrum that rounding cannot resolve: the single bounds stand
  std::vector<Index> order(static_cast<std::size_t>(s.omega.size()));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index k) { return s.omega(i) < s.omega(k); });
  const Vector single = a.error_bound;
  for (std::size_t first = 0, last; first < order.size(); first = last + 1) {
    last = first;
    while (last + 1 < order.size() && s.omega(order[last + 1]) - s.omega(order[last]) <= single(order[last]) + single(order[last + 1])) ++last;
    const std::size_t count = last - first + 1;
    if (count == 1 || count > most) continue;
    ComplexMatrix gram(static_cast<Index>(count), static_cast<Index>(count));
    double error2 = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const Index at = order[first + i];
      error2 += std::pow(own_error(at) / own_scale(at), 2);
      for (std::size_t k = 0; k < count; ++k) {
        const Index other = order[first + k];
        gram(static_cast<Index>(i), static_cast<Index>(k)) = form_between(h, s, p, at, other, s.omega(at)) / std::sqrt(own_scale(at) * own_scale(other));
      }
    }
    const double bound = std::sqrt(error2) / small::singular_values(gram).minCoeff();
    for (std::size_t i = first; i <= last; ++i) {
      a.error_bound(order[i]) = std::max(single(order[i]), bound);
      a.cluster[static_cast<std::size_t>(order[i])] = static_cast<Index>(count);
    }
  }
}

Assessment measured(const Impedance& h, dense::Spectrum& s, const Products& p) {
  const Index m = s.omega.size();
  Assessment a{Vector(m), Vector(m), Vector(m), Vector(m), Vector(m), std::vector<Index>(static_cast<std::size_t>(m), 1), false, {}};
  Vector own_scale(m), own_error(m);
  const Vector given2 = h.units().coordinate.cwiseAbs2();
  for (Index i = 0; i < m; ++i) {
    const double omega = s.omega(i);
    const ResidualVector r = residual_of(h, p, omega, i);
    const Vector r2 = squares(h, r.re, r.im), x2 = squares(h, s.re.col(i), s.im.col(i));
    const Vector weight = h.weight(omega);
    const double form = p.functional(i).slope(omega);
    own_scale(i) = weight.dot(x2);
    own_error(i) = (r2.cwiseProduct(x2)).cwiseSqrt().sum() + roundings(h.size()) * h.rounding_weight(omega).dot(x2);
    a.residual(i) = h.plain_coordinates() ? std::sqrt(r2.cwiseQuotient(given2).sum() / x2.dot(given2)) / h.given_scale(omega) : h.given_residual(whole(h, r.re, r.im), s.shape(i), omega);
    a.own_residual(i) = std::sqrt((weight.array() > 0).select(r2.cwiseQuotient(weight), 0).sum() / own_scale(i));
    a.form(i) = form / x2.sum();
    a.sensitivity(i) = own_scale(i) / std::abs(form);
    a.error_bound(i) = own_error(i) / std::abs(form);
  }
  a.no_root_twice = no_root_twice(h, s, p);
  bound_clusters(h, s, p, own_scale, own_error, a);
  sort_by_frequency(s, a);
  return a;
}

}  // namespace

Assessment assess(const Impedance& h, dense::Spectrum& s) {
  const Products p = products(h, s);
  for (Index i = 0; i < s.omega.size(); ++i) s.omega(i) = p.functional(i).corrected(s.omega(i));
  const Assessment::Unstable unstable = assess_unstable(h, s);
  Assessment a = measured(h, s, p);
  a.unstable = unstable;
  return a;
}

Assessment measure(const Impedance& h, dense::Spectrum& s) {
  Assessment a = measured(h, s, products(h, s));
  a.unstable = measure_unstable(h, s.unstable, dense::characteristic_products(h, s.unstable.right));
  return a;
}

Assessment::Unstable assess_unstable(const Impedance& h, dense::Spectrum& s) {
  const dense::CharacteristicProducts p = dense::characteristic_products(h, s.unstable.right);
  correct_unstable(s.unstable, p);
  return measure_unstable(h, s.unstable, p);
}

}  // namespace gyromode
