#include "gyromode/dense/refinement/simultaneous_roots.h"

#include "gyromode/base/rounding.h"
#include "gyromode/dense/refinement/characteristic_factor.h"
#include "gyromode/dense/pencil.h"
#include "gyromode/dense/refinement/root_moduli.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode::dense {

namespace {

// As many points on a circle within each annulus as it holds pairs, at angles that no symmetry repeats.
ComplexVector starting_points(const std::vector<Annulus>& annuli, Index pairs) {
  ComplexVector mu(pairs);
  Index at = 0;
  for (const Annulus& a : annuli) {
    const double size = a.inner * a.outer;  // |μ| = |λ|²
    for (Index k = 0; k < a.pairs; ++k) {
      const double turn = (static_cast<double>(k) + 0.29) / static_cast<double>(a.pairs) + 0.13 * static_cast<double>(at);
      mu(at++) = std::polar(size * (1 + 0.05 * static_cast<double>(k % 3)), 2 * std::numbers::pi * turn);
    }
  }
  return mu;
}

// q′/q at μ: with λ = √μ, d/dμ log det N = tr(N⁻¹N′)/2λ.
Complex logarithmic_derivative(const Impedance& h, Complex mu, Index zero) {
  const Complex lambda = std::sqrt(mu);
  return logarithmic_slope(h, lambda) / (2.0 * lambda) - static_cast<double>(zero) / mu;
}

struct Iterate {
  double least_step = infinity;  // relative
  int without_progress = 0;      // rounds since it became less
  bool settled = false;
};

void advance(const Impedance& h, Index zero, Index i, ComplexVector& mu, Iterate& state) {
  constexpr double small = 1e-4;  // steps that stop shrinking below this have reached a multiple root, or rounding
  const Complex slope = logarithmic_derivative(h, mu(i), zero);
  if (!std::isfinite(slope.real()) || !std::isfinite(slope.imag())) {  // singular to the last bit: a root
    state.settled = true;
    return;
  }
  Complex others = 0;
  for (Index k = 0; k < mu.size(); ++k) {
    if (k != i && mu(k) != mu(i)) others += 1.0 / (mu(i) - mu(k));
  }
  const Complex step = 1.0 / (slope - others);
  if (!std::isfinite(step.real()) || !std::isfinite(step.imag())) {  // the slope overflows there
    state.settled = true;
    return;
  }
  const double longest = 0.5 * std::abs(mu(i));
  const Complex taken = std::abs(step) > longest ? step * (longest / std::abs(step)) : step;
  const double size = std::abs(taken) / std::abs(mu(i));
  mu(i) -= taken;
  state.without_progress = size < 0.7 * state.least_step ? 0 : state.without_progress + 1;
  state.settled = size <= 8 * epsilon || (state.least_step <= small && state.without_progress >= 4);
  state.least_step = std::min(state.least_step, size);
}

}  // namespace

std::optional<ComplexVector> simultaneous_roots(const Impedance& h, Index pairs) {
  constexpr int most_rounds = 80;
  const auto annuli = root_moduli(h, pairs);
  if (!annuli) return std::nullopt;
  ComplexVector mu = starting_points(*annuli, pairs);
  std::vector<Iterate> states(static_cast<std::size_t>(pairs));
  for (int round = 0; round < most_rounds; ++round) {
    bool all = true;
    for (Index i = 0; i < pairs; ++i) {
      Iterate& state = states[static_cast<std::size_t>(i)];
      if (!state.settled) advance(h, h.size() - pairs, i, mu, state);
      all = all && state.settled;
    }
    if (all) return conjugate_pairs(mu);
  }
  return std::nullopt;
}

}  // namespace gyromode::dense
