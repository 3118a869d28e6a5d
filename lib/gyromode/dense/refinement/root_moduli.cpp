#include "gyromode/dense/refinement/root_moduli.h"

#include "gyromode/dense/refinement/characteristic_factor.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode::dense {

namespace {

// Pairs ±λ with |λ| < r. Roots are symmetric about both axes, so the mean over a circle is the mean of real parts over
// a quarter of it.
double pairs_within(const Impedance& h, double r) {
  constexpr int points = 4;
  double sum = 0;
  for (int k = 0; k < points; ++k) {
    const Complex lambda = std::polar(r, (k + 0.5) * std::numbers::pi / (2 * points));
    const Complex slope = logarithmic_slope(h, lambda);
    sum += std::real(lambda * slope);
  }
  return sum / (2 * points);
}

class Search {
 public:
  Search(const Impedance& h, std::vector<Annulus>& found) : h_(h), found_(found) {}

  Index within(double r) const {
    double pairs = pairs_within(h_, r);
    if (!std::isfinite(pairs)) pairs = pairs_within(h_, 1.01 * r);  // a root on the circle
    return std::isfinite(pairs) ? static_cast<Index>(std::lround(pairs)) : 0;
  }

  void between(double inner, Index inside, double outer, Index outside) {
    if (outside <= inside) return;
    if (outer <= 2 * inner) {
      found_.push_back({inner, outer, outside - inside});
      return;
    }
    const double middle = std::sqrt(inner) * std::sqrt(outer);
    const Index count = std::clamp(within(middle), inside, outside);
    between(inner, inside, middle, count);
    between(middle, count, outer, outside);
  }

 private:
  const Impedance& h_;
  std::vector<Annulus>& found_;
};

}  // namespace

std::optional<std::vector<Annulus>> root_moduli(const Impedance& h, Index pairs) {
  std::vector<Annulus> found;
  if (pairs == 0) return found;
  Search search(h, found);
  const Index zero = h.size() - pairs;
  constexpr double step = 0x1p12, largest = 0x1p400;
  double outer = 16, inner = 16 / step;
  while (search.within(outer) < h.size()) {
    if (outer > largest) return std::nullopt;
    outer *= step;
  }
  for (Index count = search.within(inner); count > zero; count = search.within(inner)) {
    if (inner < 1 / largest) return std::nullopt;
    inner /= step;
  }
  search.between(inner, zero, outer, h.size());
  Index sum = 0;
  for (const Annulus& a : found) sum += a.pairs;
  if (sum != pairs) return std::nullopt;
  return found;
}

}  // namespace gyromode::dense
