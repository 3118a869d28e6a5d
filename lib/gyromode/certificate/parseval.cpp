#include "gyromode/certificate/parseval.h"

#include "gyromode/lapack/multiply.h"

#include <cmath>
#include <random>

namespace gyromode {

namespace {

// Always the same numbers, by their own formula: what the standard library's distributions give differs between
// libraries.
Vector random_signs_and_sizes(Index n, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  Vector v(n);
  for (double& entry : v) entry = std::ldexp(static_cast<double>(generator() >> 11), -52) - 1;  // uniform in [−1, 1)
  return v;
}

// Rows of a real vector that carry real and imaginary parts: all of both without a partition.
struct Parts {
  Vector whole, re, im;
  Parts(const Impedance& h, Vector v)
      : whole(std::move(v)),
        re(h.quadrature() ? Vector(whole.head(h.split())) : whole),
        im(h.quadrature() ? Vector(whole.tail(h.size() - h.split())) : whole) {}
};

// vᵀKv and vᵀMv.
struct Energies {
  double stiffness = 0, mass = 0;
};

Energies energies(const Impedance& h, const Parts& v) {
  const RowProducts p = h.products(v.re, v.im);
  if (!h.quadrature()) return {v.re.dot(p.k_re.col(0)), v.re.dot(p.m_re.col(0))};
  return {v.re.dot(p.k_re.col(0)) + v.im.dot(p.k_im.col(0)), v.re.dot(p.m_re.col(0)) + v.im.dot(p.m_im.col(0))};
}

// |Xᴴ A v|² of all modes, from AX.
Vector squares(const Matrix& re, const Matrix& im, const Parts& v) {
  Vector real = Vector::Zero(re.cols()), imaginary = Vector::Zero(im.cols());
  lapack::multiply_add(real, 1, re, true, v.re);
  lapack::multiply_add(imaginary, 1, im, true, v.im);
  return real.cwiseAbs2() + imaginary.cwiseAbs2();
}

// Energies of the parts of (a, 0) and of (0, b), modes first.
struct Shares {
  Vector by_displacement, by_velocity;
};

Shares shares_of_modes(const Spectrum& s, const Products& p, const Parts& a, const Parts& b) {
  Vector norms(s.omega.size());
  for (Index i = 0; i < norms.size(); ++i) {
    const Functional& f = p.functional(i);
    norms(i) = f.k + s.omega(i) * s.omega(i) * f.m;
  }
  return {2 * squares(p.k_re, p.k_im, a).cwiseQuotient(norms),
          2 * squares(p.m_re, p.m_im, b).cwiseProduct(s.omega.cwiseAbs2()).cwiseQuotient(norms)};
}

// ⟨z_−λ̄, z_λ⟩ = YᴴKX − λ²YᴴMX.
Shares shares_of_unstable(const Impedance& h, const UnstableRoots& roots, const Parts& a, const Parts& b) {
  const Index count = roots.count();
  Shares shares{Vector(count), Vector(count)};
  if (count == 0) return shares;
  const auto right = h.characteristic_products(roots.right), left = h.characteristic_products(roots.left);
  const ComplexVector on_a = a.whole.cast<Complex>(), on_b = b.whole.cast<Complex>();
  for (Index i = 0; i < count; ++i) {
    const Complex lambda = roots.lambda[static_cast<std::size_t>(i)];
    const double members = lambda.imag() == 0 ? 2 : 4;
    const Complex norm = roots.left.col(i).dot(right.k.col(i)) - lambda * lambda * roots.left.col(i).dot(right.m.col(i));
    shares.by_displacement(i) = members * (right.k.col(i).dot(on_a) * std::conj(left.k.col(i).dot(on_a) / norm)).real();
    shares.by_velocity(i) =
        members * (std::conj(lambda) * right.m.col(i).dot(on_b) * std::conj(-lambda * left.m.col(i).dot(on_b) / norm)).real();
  }
  return shares;
}

}  // namespace

bool no_root_twice(const Impedance& h, const Spectrum& s, const Products& p) {
  constexpr double noticed = 1e-3;
  const Index n = h.size();
  if (!h.second_order() || s.stiffness_zero > 0 || s.omega.size() + s.divergent() + 2 * s.fluttering() != n) return false;
  const Parts a(h, random_signs_and_sizes(n, 1979)), b(h, random_signs_and_sizes(n, 2026));
  const Shares modes = shares_of_modes(s, p, a, b), unstable = shares_of_unstable(h, s.unstable, a, b);
  const double displacement_open = std::abs(modes.by_displacement.sum() + unstable.by_displacement.sum() - energies(h, a).stiffness);
  const double velocity_open = std::abs(modes.by_velocity.sum() + unstable.by_velocity.sum() - energies(h, b).mass);
  const auto all_noticed = [&](const Shares& x) {
    return ((x.by_displacement.array().abs() * noticed >= displacement_open) || (x.by_velocity.array().abs() * noticed >= velocity_open))
        .all();
  };
  return all_noticed(modes) && all_noticed(unstable);
}

}  // namespace gyromode
