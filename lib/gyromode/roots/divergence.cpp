#include "gyromode/roots/divergence.h"

#include "gyromode/base/rounding.h"
#include "gyromode/roots/singularity.h"
#include "gyromode/lapack/small.h"

#include <cmath>

namespace gyromode {

namespace {

// Phase of the determinant at λ = σ, and whether it is beyond rounding.
struct Determinant {
  Complex phase;
  bool certain;
};

Determinant determinant(const BlockedImpedance& h, const Block& block, double sigma) {
  const small::Pivots pivots = small::pivots(equilibrated_block(h, block, Complex(0, -sigma)));
  Complex phase = pivots.sign;
  for (const Complex& p : pivots.values) phase *= p == 0.0 ? Complex(1) : p / std::abs(p);
  constexpr double beyond_doubt = 16;
  const Vector sizes = pivots.values.cwiseAbs();
  return {phase, sizes.minCoeff() > beyond_doubt * h.impedance.rounding(sigma) * sizes.maxCoeff()};
}

// The sign of the determinant of a block, beside that at the first σ at which it was certain.
class SignOfDeterminant {
 public:
  SignOfDeterminant(const BlockedImpedance& h, const Block& block) : h_(h), block_(block) {}

  // 0 where rounding may have made it.
  int at(double sigma) {
    const Determinant d = determinant(h_, block_, sigma);
    if (!d.certain) return 0;
    if (reference_ == 0.0) reference_ = d.phase;
    constexpr double real = 0.9;  // cosine of the angle to the real line
    const double along = (d.phase * std::conj(reference_)).real();
    return along > real ? 1 : along < -real ? -1 : 0;
  }
  bool positive(double sigma) const { return (determinant(h_, block_, sigma).phase * std::conj(reference_)).real() > 0; }

 private:
  const BlockedImpedance& h_;
  const Block& block_;
  Complex reference_ = 0;  // not yet
};

double bisected(const SignOfDeterminant& sign, double lo, double hi, bool positive_at_lo) {
  constexpr int most_steps = 80;
  for (int step = 0; step < most_steps && hi - lo > 2 * epsilon * hi; ++step) {
    const double middle = 0.5 * (lo + hi);
    (sign.positive(middle) == positive_at_lo ? lo : hi) = middle;
  }
  return 0.5 * (lo + hi);
}

}  // namespace

std::vector<UnstableRoot> divergences(const BlockedImpedance& h, Index block) {
  // σ: below the first K is singular to rounding, above the second nothing the spin feeds can grow
  constexpr double slowest = 1e-9, fastest = 50;
  constexpr double ratio = 1.3;
  const Block& b = h.blocks[static_cast<std::size_t>(block)];
  SignOfDeterminant sign(h, b);
  std::vector<UnstableRoot> found;
  double before = 0;
  int sign_before = 0;
  for (double sigma = slowest; sigma < fastest; sigma *= ratio) {
    const int here = sign.at(sigma);
    if (here == 0) continue;
    if (sign_before != 0 && here != sign_before) {
      const double root = bisected(sign, before, sigma, sign_before > 0);
      constexpr double singular = 1e5;  // a root, not a pole
      if (relative_singularity(equilibrated_block(h, b, Complex(0, -root))) <= singular * h.impedance.rounding(root))
        found.push_back({block, root, 0, b.copies(), 0, 0});
    }
    before = sigma;
    sign_before = here;
  }
  return found;
}

}  // namespace gyromode
