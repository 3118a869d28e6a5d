#include "gyromode/refinement/undecided_flutter.h"

#include "gyromode/refinement/correct.h"

#include "gyromode/base/rounding.h"
#include "gyromode/refinement/polish.h"
#include "gyromode/dense/refinement/refine_unstable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gyromode {

namespace {

// Appends two modes at Im λ with the shape of the flutter root, phased so that the larger of its parts is as real as it
// can be.
void return_to_axis(Spectrum& s, Index k) {
  const double omega = s.unstable.lambda[static_cast<std::size_t>(k)].imag();
  ComplexVector x = s.unstable.right.col(k);
  Complex square = 0;  // the phase that makes the in-phase rows real: half the argument of Σ x²
  const Index rows = s.split < 0 ? s.size() : s.split;
  for (Index i = 0; i < rows; ++i) square += x(i) * x(i);
  x *= std::polar(1.0, -0.5 * std::arg(square));
  const Index m = s.omega.size();
  s.omega.conservativeResize(m + 2);
  s.re.conservativeResize(Eigen::NoChange, m + 2);
  s.im.conservativeResize(Eigen::NoChange, m + 2);
  for (Index c = m; c < m + 2; ++c) {
    s.omega(c) = omega;
    s.re.col(c) = x.head(s.re.rows()).real();
    s.im.col(c) = x.tail(s.im.rows()).imag();
  }
}

// Every root with Re λ ≥ 0, Im λ ≥ 0.
std::vector<Complex> all_roots(const Spectrum& s) {
  std::vector<Complex> roots;
  for (const double w : s.omega) roots.emplace_back(0, w);
  roots.insert(roots.end(), s.unstable.lambda.begin(), s.unstable.lambda.end());
  return roots;
}

// How far a root may move and still be itself: a third of the way to any other root or mirror image of one, and a tenth
// of its size.
double room_around(Complex lambda, const std::vector<Complex>& roots, std::size_t self) {
  double room = 0.1 * std::abs(lambda);
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const Complex z = roots[k];
    for (const Complex image : {z, std::conj(z), -z, -std::conj(z)}) {
      if (k == self && (image == lambda || std::abs(image - lambda) > 0.5 * std::abs(lambda))) continue;
      room = std::min(room, std::abs(image - lambda) / 3);
    }
  }
  return room;
}

// Roots with a residual above rounding, or a bound that is no small part of the growth rate, are refined by themselves,
// each by some factorisations of order n: in a large system as many as a few seconds allow, the weakest first.
bool refine_poor_roots(const dense::Impedance& h, Spectrum& s, const Assessment& a) {
  constexpr double small_part = 1e-3;
  const double enough = (s.size() <= 64 ? 1 : 6) * backward_error(s.size());
  std::vector<Index> poor;
  for (Index k = 0; k < s.unstable.count(); ++k) {
    const bool good = a.unstable.own_residual(k) <= enough &&
                      a.unstable.error_bound(k) <= small_part * s.unstable.lambda[static_cast<std::size_t>(k)].real();
    if (!good) poor.push_back(k);
  }
  std::sort(poor.begin(), poor.end(), [&](Index i, Index k) {
    return s.unstable.lambda[static_cast<std::size_t>(i)].real() < s.unstable.lambda[static_cast<std::size_t>(k)].real();
  });
  const double n = static_cast<double>(s.size());
  const std::size_t affordable = static_cast<std::size_t>(std::max(4.0, 4e6 / (n * n)));
  if (poor.size() > affordable) poor.resize(affordable);
  const std::vector<Complex> roots = all_roots(s);
  const std::size_t first = static_cast<std::size_t>(s.omega.size());
  bool changed = false;
  for (const Index k : poor) {
    Complex& lambda = s.unstable.lambda[static_cast<std::size_t>(k)];
    const auto refined = dense::refine_unstable(h, lambda, room_around(lambda, roots, first + static_cast<std::size_t>(k)));
    if (!refined || !(refined->lambda.real() > 0)) continue;
    lambda = Complex(refined->lambda.real(), std::abs(refined->lambda.imag()));
    s.unstable.right.col(k) = refined->lambda.imag() < 0 ? ComplexVector(refined->right.conjugate()) : refined->right;
    s.unstable.left.col(k) = refined->lambda.imag() < 0 ? ComplexVector(refined->left.conjugate()) : refined->left;
    changed = true;
  }
  return changed;
}

// Real vectors of the span of x and x̄, the larger part first; the same twice where x is real up to a phase.
std::pair<ComplexVector, ComplexVector> real_parts(const ComplexVector& x) {
  constexpr double independent = 1e-3;
  Complex square = x.transpose() * x;
  const ComplexVector turned = x * std::polar(1.0, -0.5 * std::arg(square));
  const ComplexVector first = turned.real().cast<Complex>(), second = turned.imag().cast<Complex>();
  return {first, second.norm() > independent * first.norm() ? second : first};
}

// Flutter so slow that its disc, or a backward error, meets the real axis is two real pairs to rounding: the real and
// the imaginary part of its vectors are theirs. It grows as well as they do, and counts as much.
bool part_double_divergence(Spectrum& s, const Assessment& a) {
  UnstableRoots parted;
  for (Index k = 0; k < s.unstable.count(); ++k) {
    const Complex lambda = s.unstable.lambda[static_cast<std::size_t>(k)];
    const ComplexVector x = s.unstable.right.col(k), y = s.unstable.left.col(k);
    const double movement = std::max(backward_error(s.size()) * a.unstable.sensitivity(k), 2 * a.unstable.error_bound(k));
    constexpr double near_defective = 2;  // there a root that has moved by rounding already has half the sensitivity
    if (lambda.imag() == 0 || lambda.imag() > near_defective * movement || lambda.real() <= movement) {
      parted.add(lambda, x, y);
    } else {
      const auto [x1, x2] = real_parts(x);
      const auto [y1, y2] = real_parts(y);
      parted.add(lambda.real(), x1, y1);
      parted.add(lambda.real(), x2, y2);
    }
  }
  const bool changed = parted.count() != s.unstable.count();
  if (changed) s.unstable = std::move(parted);
  return changed;
}

}  // namespace

void return_undecided_flutter(const dense::Impedance& h, Spectrum& s, Assessment& a) {
  if (s.unstable.count() == 0) return;
  if (refine_poor_roots(h, s, a)) a.unstable = correct_unstable(h, s);
  if (part_double_divergence(s, a)) a.unstable = correct_unstable(h, s);
  std::vector<Index> kept, returned;
  for (Index k = 0; k < s.unstable.count(); ++k) {
    const double movement = std::max(backward_error(s.size()) * a.unstable.sensitivity(k), 2 * a.unstable.error_bound(k));
    (s.unstable.divergent(k) || s.unstable.lambda[static_cast<std::size_t>(k)].real() > movement ? kept : returned).push_back(k);
  }
  if (returned.empty()) return;
  for (const Index k : returned) return_to_axis(s, k);
  s.unstable = s.unstable.chosen(kept);
  sort_by_frequency(s);
  a = measure(h, s);
  polish(h, s, a);
}

}  // namespace gyromode
