#include "gyromode/certificate/verdict.h"

#include "gyromode/certificate/polish.h"
#include "gyromode/dense/refine_unstable.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

// Flutter whose growth rate a backward error could undo goes back to the axis. Returns whether there was any.
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

struct Signs {
  std::vector<int> sign;
  Index undecided_pairs = 0;
  double gap = std::numeric_limits<double>::infinity();
};

// How far a backward error of η moves root i, capped where the root is so nearly defective that first order says nothing.
double movement(const dense::Spectrum& s, const Assessment& a, Index i) {
  return std::min(backward_error(s.size()) * a.sensitivity(i), 1e-5 * s.omega(i));
}

// The last of the roots that a backward error can make coincide, one after the other, from `first` on.
Index end_of_cluster(const dense::Spectrum& s, const Assessment& a, Index first) {
  Index last = first;
  while (last + 1 < s.omega.size() && s.omega(last + 1) - s.omega(last) <= movement(s, a, last) + movement(s, a, last + 1)) ++last;
  return last;
}

// A root with a form far above rounding has the sign of its form.
bool sure(const dense::Spectrum& s, const Assessment& a, Index i) { return backward_error(s.size()) * a.sensitivity(i) <= 1e-7 * s.omega(i); }

// Positive minus negative eigenvalues of the form X_cᴴ(2ωM − jG)X_c on the unit shapes of a cluster: its signs, by Sylvester's law, if the shapes are
// independent and the form regular, both far from doubt.
std::optional<Index> signature(const Impedance& h, const dense::Spectrum& s, Index first, Index last) {
  constexpr double regular = 1e-5;
  const Index count = last - first + 1;
  ComplexMatrix x(s.size(), count);
  for (Index i = 0; i < count; ++i) x.col(i) = s.shape(first + i).normalized();
  const auto weakest = [](const Vector& v) { return v.cwiseAbs().minCoeff() / v.cwiseAbs().maxCoeff(); };
  const Vector lengths = Eigen::SelfAdjointEigenSolver<ComplexMatrix>(x.adjoint() * x, Eigen::EigenvaluesOnly).eigenvalues();
  const ComplexMatrix form = h.form(x, 0.5 * (s.omega(first) + s.omega(last)));
  const Vector values = Eigen::SelfAdjointEigenSolver<ComplexMatrix>(form, Eigen::EigenvaluesOnly).eigenvalues();
  if (!(weakest(lengths) > regular) || !(weakest(values) > regular)) return std::nullopt;
  return (values.array() > 0).count() - (values.array() < 0).count();
}

// Positive minus negative roots in a cluster: the change of n₋(H) across it, counted as near to it as the factorisations are sure, and no farther than
// half way to the roots beside it.
std::optional<Index> jump(const Impedance& h, const dense::Spectrum& s, const Assessment& a, Index first, Index last) {
  const double before = first > 0 ? s.omega(first - 1) + movement(s, a, first - 1) : 0;
  const double after = last + 1 < s.omega.size() ? s.omega(last + 1) - movement(s, a, last + 1) : 2 * s.omega(last);
  if (!(before < s.omega(first)) || !(after > s.omega(last))) return std::nullopt;
  for (double factor = 4; factor <= 4096; factor *= 8) {
    const double below = std::max(s.omega(first) - factor * movement(s, a, first), 0.5 * (before + s.omega(first)));
    const double above = std::min(s.omega(last) + factor * movement(s, a, last), 0.5 * (after + s.omega(last)));
    const Inertia low = h.negative_at(below);
    const Inertia high = h.negative_at(above);
    if (!low.doubtful() && !high.doubtful()) return high.negative - low.negative;
  }
  return std::nullopt;
}

// Signs of the roots of a cluster: `difference` = p − q of p positive and q negative ones. Pairs of opposite sign get 0 and 0.
void assign(Signs& signs, Index first, Index last, Index difference) {
  const Index count = last - first + 1;
  const Index surplus = std::abs(difference);
  if (surplus > count || (count - surplus) % 2 != 0) return;  // contradicts the roots found: the forms stand, and the balance will tell
  for (Index i = first; i <= last; ++i) signs.sign[static_cast<std::size_t>(i)] = i - first < count - surplus ? 0 : (difference > 0 ? 1 : -1);
  signs.undecided_pairs += (count - surplus) / 2;
}

Signs energy_signs(const Impedance& h, const dense::Spectrum& s, const Assessment& a) {
  Signs signs;
  const Index m = s.omega.size();
  for (Index i = 0; i < m; ++i) signs.sign.push_back(a.form(i) > 0 ? 1 : -1);
  for (Index first = 0, last; first < m; first = last + 1) {
    last = end_of_cluster(s, a, first);
    bool all_sure = true;
    Index difference = 0;
    for (Index i = first; i <= last; ++i) {
      all_sure = all_sure && sure(s, a, i);
      difference += signs.sign[static_cast<std::size_t>(i)];
    }
    if (all_sure && first == last) continue;
    std::optional<Index> known = all_sure ? signature(h, s, first, last) : std::nullopt;
    if (!known) known = jump(h, s, a, first, last);
    assign(signs, first, last, known.value_or(difference));
  }
  for (Index i = 0; i + 1 < m; ++i) {
    const int product = signs.sign[static_cast<std::size_t>(i)] * signs.sign[static_cast<std::size_t>(i + 1)];
    if (product < 0) signs.gap = std::min(signs.gap, (s.omega(i + 1) - s.omega(i)) / s.omega(i + 1));
  }
  if (signs.undecided_pairs > 0) signs.gap = 0;
  return signs;
}

// K ≥ 0: energy is positive in every motion (theory §4).
Signs all_positive(const dense::Spectrum& s) {
  Signs signs;
  signs.sign.assign(static_cast<std::size_t>(s.omega.size()), 1);
  return signs;
}

IndexBalance balance_of(const dense::Spectrum& s, const Signs& signs) {
  IndexBalance b;
  b.negative = s.stiffness_negative;
  b.real_pairs = static_cast<Index>(s.divergence.size());
  b.quadruples = static_cast<Index>(s.flutter.size());
  b.negative_energy = std::count(signs.sign.begin(), signs.sign.end(), -1) + signs.undecided_pairs;
  b.zero = s.zero_pairs();
  b.zero_negative = s.stiffness_negative - s.reduced_negative;
  const Index found = s.omega.size() + b.zero + b.real_pairs + 2 * b.quadruples;
  b.closed = found == s.size() && s.reduced_negative == b.real_pairs + 2 * b.quadruples + 2 * b.negative_energy;
  return b;
}

}  // namespace

std::string_view word(Stability s) {
  switch (s) {
    case Stability::stable: return "stable";
    case Stability::gyroscopically_stabilised: return "gyroscopically_stabilised";
    case Stability::unknown: return "unknown";
    case Stability::marginal: return "marginal";
    default: return "unstable";
  }
}

IndexBalance& IndexBalance::operator+=(const IndexBalance& other) {
  negative += other.negative;
  real_pairs += other.real_pairs;
  quadruples += other.quadruples;
  negative_energy += other.negative_energy;
  zero += other.zero;
  zero_negative += other.zero_negative;
  closed = closed && other.closed;
  return *this;
}

Verdict judge(const Impedance& h, dense::Spectrum& s, Assessment& a) {
  Verdict v;
  if (!h.second_order()) {  // I > 0: every mode has positive energy
    v.energy_sign.assign(static_cast<std::size_t>(s.omega.size()), 1);
    v.balance.zero = s.zero_pairs();
    v.balance.closed = s.size() == 2 * s.omega.size() + s.zero_pairs();
    v.stability = v.balance.closed ? Stability::stable : Stability::unknown;
    v.gap = std::numeric_limits<double>::infinity();
    return v;
  }
  const bool flutter_undecided = return_undecided_flutter(h, s, a);
  const Signs signs = s.stiffness_negative == 0 ? all_positive(s) : energy_signs(h, s, a);
  v.energy_sign = signs.sign;
  v.gap = signs.gap;
  v.balance = balance_of(s, signs);
  if (s.stiffness_negative == 0) {
    v.stability = v.balance.closed ? Stability::stable : Stability::unknown;
  } else if (!s.divergence.empty() || !s.flutter.empty()) {
    v.stability = Stability::unstable;
  } else if (flutter_undecided || signs.undecided_pairs > 0 || s.zero_pairs() > 0) {
    v.stability = Stability::marginal;
  } else {
    v.stability = v.balance.closed ? Stability::gyroscopically_stabilised : Stability::unknown;
  }
  return v;
}

}  // namespace gyromode
