#include "gyromode/certificate/undecided_flutter.h"

#include "gyromode/certificate/polish.h"
#include "gyromode/dense/refine_unstable.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gyromode {

namespace {

// Appends two modes at Im λ with the shape of the flutter root, phased so that the larger of its parts is as real as it can be.
void return_to_axis(dense::Spectrum& s, Index k) {
  const double omega = s.flutter[static_cast<std::size_t>(k)].imag();
  ComplexVector x = s.flutter_shapes.col(k);
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
std::vector<Complex> all_roots(const dense::Spectrum& s) {
  std::vector<Complex> roots;
  for (const double w : s.omega) roots.emplace_back(0, w);
  roots.insert(roots.end(), s.divergence.begin(), s.divergence.end());
  roots.insert(roots.end(), s.flutter.begin(), s.flutter.end());
  return roots;
}

// How far a root may move and still be itself: a third of the way to any other root or mirror image of one, and a tenth of its size.
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

// Growth rates so far from the axis that no backward error brings them back to it are left as the solver found them; the rest are refined on the
// matrices as given. Returns how far a backward error moves each flutter root.
std::vector<double> refine_weak_roots(const Impedance& h, dense::Spectrum& s) {
  constexpr double strong = 1e-2;
  constexpr Index small = 64;  // here every root is refined: it costs next to nothing
  const std::vector<Complex> roots = all_roots(s);
  double largest = 0;
  for (const Complex& z : roots) largest = std::max(largest, std::abs(z));
  const std::size_t first_real = static_cast<std::size_t>(s.omega.size());
  for (std::size_t k = 0; k < s.divergence.size(); ++k) {
    double& sigma = s.divergence[k];
    if (s.size() <= small || sigma < strong * largest) sigma = dense::refine_unstable(h, sigma, room_around(sigma, roots, first_real + k)).lambda.real();
  }
  std::vector<double> movement;
  for (std::size_t k = 0; k < s.flutter.size(); ++k) {
    if (s.size() > small && s.flutter[k].real() >= strong * largest) {
      movement.push_back(0);
      continue;
    }
    const double room = room_around(s.flutter[k], roots, first_real + s.divergence.size() + k);
    const dense::UnstableRoot root = dense::refine_unstable(h, s.flutter[k], room);
    movement.push_back(backward_error(s.size()) * root.sensitivity);
    if (!(root.lambda.real() > 0) || root.shape.isZero(0)) continue;
    s.flutter[k] = Complex(root.lambda.real(), std::abs(root.lambda.imag()));
    s.flutter_shapes.col(static_cast<Index>(k)) = root.shape;
  }
  return movement;
}

}  // namespace

bool return_undecided_flutter(const Impedance& h, dense::Spectrum& s, Assessment& a) {
  const std::vector<double> movement = refine_weak_roots(h, s);
  std::vector<Complex> decided;
  std::vector<Index> columns;
  for (std::size_t k = 0; k < movement.size(); ++k) {
    if (s.flutter[k].real() > movement[k]) {
      decided.push_back(s.flutter[k]);
      columns.push_back(static_cast<Index>(k));
    } else {
      return_to_axis(s, static_cast<Index>(k));
    }
  }
  if (decided.size() == s.flutter.size()) return false;
  s.flutter = std::move(decided);
  s.flutter_shapes = ComplexMatrix(s.flutter_shapes(Eigen::all, columns));
  a = measure(h, s);
  polish(h, s, a);
  return true;
}

}  // namespace gyromode
