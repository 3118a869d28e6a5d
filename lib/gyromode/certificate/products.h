#pragma once

#include "gyromode/spectrum/impedance.h"
#include "gyromode/spectrum/spectrum.h"

#include <vector>

namespace gyromode {

/// Xᴴ(K + ωjG − ω²M)X = −ω²m + ωg + k (second order), or Xᴴ(ωI − jG)X = ωm − g (first order), of one shape.
struct Functional {
  double m = 0, g = 0, k = 0;
  bool second_order = true;

  double value(double omega) const { return second_order ? k + omega * (g - omega * m) : omega * m - g; }
  /// −d/dω in second order, d/dω in first: the form whose sign is the energy sign.
  double slope(double omega) const { return second_order ? 2 * omega * m - g : m; }
};

/// The products of all shapes of a Spectrum, and the functional of each.
struct Products : RowProducts {
  std::vector<Functional> functionals;

  const Functional& functional(Index i) const { return functionals[static_cast<std::size_t>(i)]; }
  /// Those of the shapes in another order.
  void reorder(const std::vector<Index>& order);
};
Products products(const Impedance& h, const Spectrum& s);

}  // namespace gyromode
