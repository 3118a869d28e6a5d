#pragma once

#include "gyromode/base/types.h"

#include <cmath>

namespace gyromode {

/// How a field of one unknown answers two loads, symmetric 2 × 2: C = Q/φ − lump, with φ = 0 at its fixed-root
/// frequencies, where Q has rank 1: det Q = φ · det.
template <class T>
struct FieldResponse {
  T phi;
  T q11, q12, q22;
  T det;
  T lump11, lump12, lump22;

  /// C in units in which the loads are divided by s1 and s2.
  FieldResponse scaled(const T& s1, const T& s2) const {
    return {
        phi, s1 * s1 * q11, s1 * s2 * q12, s2 * s2 * q22, s1 * s1 * s2 * s2 * det, s1 * s1 * lump11, s1 * s2 * lump12, s2 * s2 * lump22};
  }
};

/// C = e eᵀ a/φ + regular with eᵀe = 1, a the eigenvalue of Q that is larger in modulus: the pole in one direction of
/// the loads. A coordinate x is kept for it,
///     [ H − Wᵀ regular W   √s Wᵀe ]                  H − Wᵀ C W
///     [ √s eᵀW             sφ/a   ]   instead of                     for loads W y.
template <class T>
struct Pole {
  T e1, e2;
  T a;
  T regular11, regular12, regular22;

  explicit Pole(const FieldResponse<T>& c) {
    const T half = 0.5 * (c.q11 - c.q22);
    const T mean = 0.5 * (c.q11 + c.q22);
    T root = std::sqrt(half * half + c.q12 * c.q12);
    if (std::abs(mean - root) > std::abs(mean + root)) root = -root;
    a = mean + root;
    const bool first = std::abs(half + root) >= std::abs(root - half);
    e1 = first ? T(root + half) : c.q12;
    e2 = first ? c.q12 : T(root - half);
    if (e1 == T(0) && e2 == T(0)) e1 = 1;  // Q = a 1: any direction
    // one sign, lest borders turn over from one frequency to the next
    const T length = (std::real(e1) < 0 ? -1.0 : 1.0) * std::sqrt(e1 * e1 + e2 * e2);
    e1 /= length;
    e2 /= length;
    const T rest = c.det / a;
    regular11 = rest * e2 * e2 - c.lump11;
    regular12 = -rest * e1 * e2 - c.lump12;
    regular22 = rest * e1 * e1 - c.lump22;
  }
};

/// The entries of the kept coordinate: `own` = sφ/a, with √s on either side of its border. Real: s = |a|/√(φ² + a²),
/// bounded and smooth at the pole and far from it.
template <class T>
struct LiftedEntry {
  T own, left, right;
};
inline LiftedEntry<double> kept(const Pole<double>& p, double phi) {
  const double size = std::hypot(phi, p.a);
  const double border = std::sqrt(std::abs(p.a) / size);
  return {(p.a < 0 ? -phi : phi) / size, border, border};
}
/// (Cℓ)₁, what the field does against the first load: finite at a pole, where eᵀℓ a/φ = −√s x.
inline Complex first_of_answer(const FieldResponse<double>& answer, const Complex& x, const Eigen::Vector2cd& loads) {
  const Pole<double> pole(answer);
  return -kept(pole, answer.phi).left * x * pole.e1 + pole.regular11 * loads(0) + pole.regular12 * loads(1);
}
/// Complex: analytic.
inline LiftedEntry<Complex> kept(const Pole<Complex>& p, const Complex& phi) { return {phi, 1, p.a}; }

}  // namespace gyromode
