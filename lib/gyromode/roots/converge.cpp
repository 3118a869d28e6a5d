#include "gyromode/roots/converge.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

// crossing() of one bracket, with the narrowest ends at which it is beyond doubt.
class Crossing {
 public:
  Crossing(const BlockedImpedance& h, const Bracket& b) : h_(h), bracket_(b), lo_(b.lo), hi_(b.hi) {}

  double operator()(double omega) { return look(omega, h_.impedance.at(omega)); }

  double look(double omega, const Lifted& lifted) {
    const BlockState s = state_of(h_.blocks[static_cast<std::size_t>(bracket_.block)], lifted);
    const double value = crossing(s, bracket_.count, bracket_.change);
    if (std::abs(s.nearest) > 8 * h_.impedance.rounding(omega) * s.size) {
      if (value > 0)
        lo_ = std::max(lo_, omega);
      else
        hi_ = std::min(hi_, omega);
    }
    return value;
  }
  double lo() const { return lo_; }
  double hi() const { return hi_; }

 private:
  const BlockedImpedance& h_;
  const Bracket& bracket_;
  double lo_, hi_;
};

// Chandrupatla's hybrid method (Adv. Eng. Software 28 (1997) 145): inverse quadratic interpolation where its condition
// says that the function is tame enough, else bisection. Ends where the next step would be below what the last one can
// leave, and takes that step.
double zero_of(Crossing& f, double a, double fa, double b, double fb) {
  constexpr double last_step = 1e-12;  // relative; convergence is faster than linear there
  constexpr double unit = 1.2e-16;
  // The counts put the root inside, whatever rounding makes of an end that stands on a neighbour.
  constexpr double least_value = 1e-300;
  fa = std::max(fa, least_value);
  fb = std::min(fb, -least_value);
  double c = a, fc = fa, t = std::clamp(fa / (fa - fb), 0.05, 0.95);
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

std::vector<Root> converge(const BlockedImpedance& h, const Bracket& bracket) {
  const Block& block = h.blocks[static_cast<std::size_t>(bracket.block)];
  Root root;
  root.block = bracket.block;
  Crossing crossing(h, bracket);
  root.omega =
      bracket.roots == 1 ? zero_of(crossing, bracket.lo, bracket.value_lo, bracket.hi, bracket.value_hi) : 0.5 * (bracket.lo + bracket.hi);
  const Lifted at = h.impedance.at(root.omega);
  const double step = std::clamp(1e-6 * (bracket.hi - bracket.lo), 1e-10 * root.omega, 1e-6 * root.omega);
  const Lifted beyond = h.impedance.at(root.omega + step);
  if (bracket.roots == 1) crossing.look(root.omega + step, beyond);
  root.energy_sign = bracket.change == bracket.roots ? 1 : bracket.change == -bracket.roots ? -1 : 0;
  root.lo = crossing.lo();
  root.hi = crossing.hi();
  const BlockState state = state_of(block, at);
  const Index first = crossing_position(state, bracket.count, bracket.change);
  const Index size = std::min(bracket.roots, block.size());
  std::vector<Root> found;
  for (Index k = 0; k < size; ++k) {
    BlockEigenpair pair = eigenpair(block, at, std::clamp<Index>(bracket.change < 0 ? first - k : first + k, 0, block.size() - 1));
    root.value = pair.value;
    root.slope = slope_between(at.matrix, beyond.matrix, pair.vector, step);
    // The direction of a pole has no sign of its own, and may turn over between the two: not at both sides.
    if (root.slope * root.energy_sign > 0)
      root.slope = slope_between(at.matrix, h.impedance.at(root.omega - step).matrix, pair.vector, -step);
    root.error = (std::abs(pair.value) + h.impedance.rounding(root.omega) * state.size) / std::abs(root.slope);
    root.vector = std::move(pair.vector);
    found.push_back(root);
  }
  for (const Index twin : block.equal_blocks) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(size); ++k) {
      Root copy = found[k];
      std::swap(copy.vector(block.coordinates[0]), copy.vector(twin));
      found.push_back(std::move(copy));
    }
  }
  return found;
}

}  // namespace gyromode
