#include "gyromode/certificate/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gyromode {

namespace {

// A backward error of this size, relative to ‖K‖ + ω‖G‖ + ω²‖M‖, is within what reading and solving the model may have done.
double backward_error(Index n) { return 4 * static_cast<double>(std::max<Index>(n, 2)) * std::numeric_limits<double>::epsilon(); }

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

// Flutter whose growth rate a backward error could undo. Returns whether there was any.
bool return_undecided_flutter(const Impedance& h, dense::Spectrum& s, Assessment& a) {
  bool any = false;
  for (std::size_t k = 0; k < s.flutter.size();) {
    if (s.flutter[k].real() > s.flutter_uncertainty[k]) {
      ++k;
      continue;
    }
    any = true;
    return_to_axis(s, static_cast<Index>(k));
    s.flutter.erase(s.flutter.begin() + static_cast<std::ptrdiff_t>(k));
    s.flutter_uncertainty.erase(s.flutter_uncertainty.begin() + static_cast<std::ptrdiff_t>(k));
    const Index last = s.flutter_shapes.cols() - 1;
    for (Index c = static_cast<Index>(k); c < last; ++c) s.flutter_shapes.col(c) = s.flutter_shapes.col(c + 1).eval();
    s.flutter_shapes.conservativeResize(Eigen::NoChange, last);
  }
  if (any) a = assess(h, s);
  return any;
}

struct Signs {
  std::vector<int> sign;
  bool undecided_pair = false;
  Index pairs = 0;  ///< undecided pairs
  double gap = std::numeric_limits<double>::infinity();
};

// Neighbours of opposite sign whose distance a backward error bridges get the sign 0.
Signs energy_signs(Index n, const dense::Spectrum& s, const Assessment& a) {
  const double eta = backward_error(n);
  Signs result;
  const Index m = s.omega.size();
  for (Index i = 0; i < m; ++i) result.sign.push_back(a.form(i) > 0 ? 1 : -1);
  // A root whose own form drowns in the backward error has no sign: it sits in a (nearly) defective pair.
  for (Index i = 0; i + 1 < m; ++i) {
    const std::size_t k = static_cast<std::size_t>(i);
    if (result.sign[k] == 0) continue;
    const double distance = s.omega(i + 1) - s.omega(i);
    const bool bridged = distance <= eta * (a.sensitivity(i) + a.sensitivity(i + 1));
    const bool opposite = result.sign[k] != result.sign[k + 1];
    const bool defective = std::max(a.sensitivity(i), a.sensitivity(i + 1)) * eta >= 0.1 * s.omega(i + 1);
    if (opposite) result.gap = std::min(result.gap, distance / s.omega(i + 1));
    if (bridged && (opposite || defective)) {
      result.sign[k] = result.sign[k + 1] = 0;
      result.undecided_pair = true;
      ++result.pairs;
      ++i;
    }
  }
  return result;
}

IndexBalance balance_of(const dense::Spectrum& s, const Signs& signs) {
  IndexBalance b;
  b.negative = s.stiffness_negative;
  b.real_pairs = static_cast<Index>(s.divergence.size());
  b.quadruples = static_cast<Index>(s.flutter.size());
  b.negative_energy = std::count(signs.sign.begin(), signs.sign.end(), -1) + signs.pairs;
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
  const Signs signs = energy_signs(h.size(), s, a);
  v.energy_sign = signs.sign;
  v.gap = signs.gap;
  v.balance = balance_of(s, signs);
  if (s.stiffness_negative == 0) {
    v.stability = v.balance.closed ? Stability::stable : Stability::unknown;
  } else if (!s.divergence.empty() || !s.flutter.empty()) {
    v.stability = Stability::unstable;
  } else if (flutter_undecided || signs.undecided_pair || s.zero_pairs() > 0) {
    v.stability = Stability::marginal;
  } else {
    v.stability = v.balance.closed ? Stability::gyroscopically_stabilised : Stability::unknown;
  }
  return v;
}

}  // namespace gyromode
