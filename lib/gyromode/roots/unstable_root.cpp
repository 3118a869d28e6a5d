#include "gyromode/roots/unstable_root.h"

#include "gyromode/roots/singularity.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

ComplexMatrix block_at(const BlockedImpedance& h, const Block& b, const Complex& z) {
  const ComplexMatrix whole = h.impedance.at(z);
  return whole(b.coordinates, b.coordinates);
}

Complex bordered(const ComplexMatrix& a, const ComplexVector& u, const ComplexVector& v) {
  const Index n = a.rows();
  ComplexMatrix m(n + 1, n + 1);
  m << a, u, v.adjoint(), ComplexMatrix::Zero(1, 1);
  ComplexVector right = ComplexVector::Zero(n + 1);
  right(n) = 1;
  return small::solve_fully_pivoted(m, right)(n);
}

// Whether z is away from both axes by more than rounding may have moved it. Near an axis two roots meet, g ≈ c((z −
// z₀)² + d²), and the error of z is that of g over |g′| ≈ 2cd: g′ is taken over a step of the distance d.
bool resolved(const BlockedImpedance& h, const Block& b, const Complex& z, bool divergence, const ComplexVector& u,
              const ComplexVector& v) {
  constexpr double of_distance = 0.1, beyond_doubt = 64;
  const double distance = divergence ? -z.imag() : std::min(-z.imag(), z.real());
  const Complex step = of_distance * distance * (divergence ? Complex(0, 1) : Complex(1));
  const double change = std::abs(bordered(block_at(h, b, z + step), u, v) - bordered(block_at(h, b, z - step), u, v));
  return change > beyond_doubt * h.impedance.rounding(std::abs(z)) * std::max(1.0, block_at(h, b, z).cwiseAbs().maxCoeff());
}

}  // namespace

std::optional<UnstableRoot> unstable_root(const BlockedImpedance& h, Index block, Complex seed) {
  const Block& b = h.blocks[static_cast<std::size_t>(block)];
  const bool divergence = seed.imag() == 0;
  const Complex minus_j(0, -1);
  const Complex start = minus_j * seed;
  const small::Svd svd = small::singular_value_decomposition(block_at(h, b, start));
  const ComplexVector u = svd.u.rightCols(1), v = svd.v.rightCols(1);
  const auto on_axis = [&](const Complex& z) { return divergence ? Complex(0, z.imag()) : z; };
  constexpr double first_step = 1e-4, reach = 0.1;
  const double size = std::abs(seed);
  const double rounding = h.impedance.rounding(size);
  Complex before = start, z = on_axis(start * (1 + first_step));
  Complex g_before = bordered(block_at(h, b, before), u, v);
  constexpr int most_steps = 40;
  bool settled = false;
  for (int step = 0; step < most_steps && !settled; ++step) {
    const Complex g = bordered(block_at(h, b, z), u, v);
    const Complex move = -g * (z - before) / (g - g_before);
    if (!std::isfinite(std::abs(move))) {
      settled = std::abs(z - before) <= 1e-10 * size;
      break;
    }
    before = z;
    g_before = g;
    z = on_axis(z + move);
    if (!(std::abs(z - start) <= reach * size)) return std::nullopt;
    settled = std::abs(move) <= 64 * rounding * size;
  }
  const double growth = -z.imag();
  const double omega = divergence ? 0 : z.real();
  constexpr double certainty = 1e4;  // growth rates nearer to rounding are no growth
  if (!settled || !(growth > certainty * rounding * size) || omega < 0) return std::nullopt;
  if (!resolved(h, b, z, divergence, u, v)) return std::nullopt;
  if (!(relative_singularity(equilibrated_block(h, b, z)) <= 1e5 * rounding)) return std::nullopt;
  UnstableRoot root{block, growth, omega, b.copies(), 0, 0};
  measure(h, root);
  return root;
}

void measure(const BlockedImpedance& h, UnstableRoot& root) {
  constexpr double part = 1e-5;  // of λ: the step of the differences, whose error is its square
  const Block& b = h.blocks[static_cast<std::size_t>(root.block)];
  const Complex z(root.omega, -root.growth);
  const ComplexMatrix a = block_at(h, b, z);
  const small::Svd svd = small::singular_value_decomposition(a);
  const ComplexVector u = svd.u.rightCols(1), v = svd.v.rightCols(1);
  const Complex step = part * z;
  const double slope = std::abs(bordered(block_at(h, b, z + step), u, v) - bordered(block_at(h, b, z - step), u, v)) / (2 * std::abs(step));
  const double size = std::abs(bordered(a, u, v));
  root.residual = size / (std::abs(z) * slope);
  root.error = (size + h.impedance.rounding(std::abs(z)) * std::max(1.0, a.cwiseAbs().maxCoeff())) / slope;
}

}  // namespace gyromode
