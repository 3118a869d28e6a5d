#pragma once

#include "gyromode/dense/impedance.h"

#include <vector>

namespace gyromode {

/// Xᴴ(K + ωjG − ω²M)X = −ω²m + ωg + k (second order), or Xᴴ(ωI − jG)X = ωm − g (first order), of one shape.
struct Functional {
  double m = 0, g = 0, k = 0;
  bool second_order = true;

  double value(double omega) const { return second_order ? k + omega * (g - omega * m) : omega * m - g; }
  /// −d/dω in second order, d/dω in first: the form whose sign is the energy sign.
  double slope(double omega) const { return second_order ? 2 * omega * m - g : m; }
  /// The root near ω. A step is taken while it shrinks |value| and stays a small part of ω.
  double corrected(double omega) const;
};

/// K X, M X and jG X of all shapes, real and imaginary parts, each of the rows that carry it: X = re + j im gives jGX = −G_ri im + j G_ir re, G_ir = −G_riᵀ; and the functional of each shape.
struct Products {
  Matrix k_re, k_im, m_re, m_im, g_re, g_im;
  std::vector<Functional> functionals;

  const Functional& functional(Index i) const { return functionals[static_cast<std::size_t>(i)]; }
};
Products products(const Impedance& h, const dense::Spectrum& s);

}  // namespace gyromode
