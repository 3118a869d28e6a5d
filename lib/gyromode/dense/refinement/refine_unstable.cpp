#include "gyromode/dense/refinement/refine_unstable.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/refinement/characteristic_factor.h"

#include <cmath>

namespace gyromode::dense {

std::optional<UnstableRoot> refine_unstable(const Impedance& h, Complex lambda, double reach) {
  constexpr int most_steps = 8;
  constexpr double settled = 64 * epsilon;
  const bool real = lambda.imag() == 0;
  const Complex start = lambda;
  std::optional<UnstableRoot> last;
  double previous = infinity;
  for (int step = 0; step < most_steps; ++step) {
    const NullPair v = null_pair(h, lambda);
    if (!v.right.allFinite() || !v.left.allFinite()) {  // singular to the last bit
      lambda *= 1 + 4 * epsilon;
      continue;
    }
    const Complex slope = v.left.dot(h.characteristic_slope_at(lambda) * v.right);
    Complex change = -v.left.dot(h.characteristic_at(lambda) * v.right) / slope;
    if (real) change = change.real();
    last = UnstableRoot{lambda, v.right, v.left};
    const double size = std::abs(change);
    if (!(size <= reach) || !(std::abs(lambda + change - start) <= reach)) return std::nullopt;
    // at rounding, or near a defective root: what was reached, with its own vectors
    if (!(size < 0.5 * previous) || size <= settled * std::abs(lambda)) return last;
    lambda += change;
    previous = size;
  }
  return last;
}

}  // namespace gyromode::dense
