#include "gyromode/impedance/converge.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// The eigenvalue that changes sign in the bracket, made positive below the root and negative above it whatever the energy.
class Crossing {
 public:
  Crossing(const BlockedImpedance& h, const Bracket& b, const GrowingCount& growing) : h_(h), bracket_(b), growing_(growing), lo_(b.lo), hi_(b.hi) {}

  double operator()(double omega) { return look(omega, h_.impedance.at(omega)); }

  double look(double omega, const Lifted& lifted) {
    const BlockState s = state_of(h_.blocks[static_cast<std::size_t>(bracket_.block)], lifted);
    const bool below = growing_(bracket_.block, omega, s.count) <= bracket_.below;
    const double size = std::abs(s.nearest);
    if (size > 8 * h_.impedance.rounding(omega)) {
      double& end = below ? lo_ : hi_;
      end = below ? std::max(end, omega) : std::min(end, omega);
    }
    return below ? size : -size;
  }
  double lo() const { return lo_; }
  double hi() const { return hi_; }

 private:
  const BlockedImpedance& h_;
  const Bracket& bracket_;
  const GrowingCount& growing_;
  double lo_, hi_;
};

// Chandrupatla's hybrid method (Adv. Eng. Software 28 (1997) 145): inverse quadratic interpolation where its condition says that the function is tame enough, else bisection. Ends
// where the next step would be below what the last one can leave, and takes that step.
double zero_of(Crossing& f, double a, double fa, double b, double fb) {
  constexpr double last_step = 1e-12;  // relative; convergence is faster than linear there
  constexpr double unit = 1.2e-16;
  double c = a, fc = fa, t = 0.5;
  if (fa == 0) return a;
  if (fb == 0) return b;
  t = std::clamp(fa / (fa - fb), 0.05, 0.95);
  constexpr int most_steps = 200;
  for (int step = 0; step < most_steps; ++step) {
    const double x = a + t * (b - a);
    const double fx = f(x);
    if (fx == 0) return x;
    if ((fx < 0) == (fa < 0)) {
      c = a;
      fc = fa;
    } else {
      c = b;
      fc = fb;
      b = a;
      fb = fa;
    }
    a = x;
    fa = fx;
    const double width = std::abs(b - a);
    const double best = std::abs(fa) < std::abs(fb) ? a : b;
    if (width <= 2 * unit * best) return best;
    const double xi = (a - b) / (c - b);
    const double phi = (fa - fb) / (fc - fb);
    t = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi) {
      t = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
      if (t >= 0 && t * width <= last_step * best) return a + t * (b - a);
    }
    const double least = unit * best / width;
    t = std::clamp(t, least, 1 - least);
  }
  return std::abs(fa) < std::abs(fb) ? a : b;
}

double slope_between(const ComplexMatrix& at, const ComplexMatrix& beyond, const ComplexVector& x, double step) {
  return (x.dot(beyond * x).real() - x.dot(at * x).real()) / step;
}

}  // namespace

std::vector<Root> converge(const BlockedImpedance& h, const Bracket& bracket, const GrowingCount& growing) {
  const Block& block = h.blocks[static_cast<std::size_t>(bracket.block)];
  Root root;
  root.block = bracket.block;
  root.together = bracket.roots * block.copies();
  Crossing crossing(h, bracket, growing);
  root.omega = bracket.roots == 1 ? zero_of(crossing, bracket.lo, bracket.nearest_lo, bracket.hi, -bracket.nearest_hi) : 0.5 * (bracket.lo + bracket.hi);
  const Lifted at = h.impedance.at(root.omega);
  const double step = 1e-6 * std::min(1.0, root.omega);
  const Lifted beyond = h.impedance.at(root.omega + step);
  if (bracket.roots == 1) crossing.look(root.omega + step, beyond);
  root.energy_sign = bracket.change == bracket.roots ? 1 : bracket.change == -bracket.roots ? -1 : 0;
  root.lo = crossing.lo();
  root.hi = crossing.hi();
  std::vector<Root> found;
  for (Index k = 0; k < std::min(bracket.roots, block.size()); ++k) {
    NearestEigenpair pair = nearest_eigenpair(block, at, k);
    root.value = pair.value;
    root.slope = slope_between(at.matrix, beyond.matrix, pair.vector, step);
    // The direction of a pole has no sign of its own, and may turn over between the two: not at both sides.
    if (root.slope * root.energy_sign > 0) root.slope = slope_between(at.matrix, h.impedance.at(root.omega - step).matrix, pair.vector, -step);
    root.error = (std::abs(pair.value) + h.impedance.rounding(root.omega)) / std::abs(root.slope);
    root.vector = std::move(pair.vector);
    found.push_back(root);
  }
  for (const Index twin : block.twins) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(std::min(bracket.roots, block.size())); ++k) {
      Root copy = found[k];
      std::swap(copy.vector(block.coordinates[0]), copy.vector(twin));
      found.push_back(std::move(copy));
    }
  }
  return found;
}

}  // namespace gyromode
