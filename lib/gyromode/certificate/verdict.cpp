#include "gyromode/certificate/verdict.h"

#include "gyromode/certificate/energy_signs.h"
#include "gyromode/certificate/undecided_flutter.h"

#include <algorithm>

namespace gyromode {

namespace {

IndexBalance balance_of(const dense::Spectrum& s, const EnergySigns& signs) {
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

// Every pair of roots of I q̇ + G q = 0 is a mode or two constant solutions.
IndexBalance first_order_balance(const dense::Spectrum& s) {
  IndexBalance b;
  b.zero = s.zero_pairs();
  b.closed = s.size() == 2 * s.omega.size() + s.zero_pairs();
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
  const bool flutter_undecided = h.second_order() && return_undecided_flutter(h, s, a);
  const EnergySigns signs = energy_signs(h, s, a);
  Verdict v;
  v.energy_sign = signs.sign;
  v.gap = signs.gap;
  v.balance = h.second_order() ? balance_of(s, signs) : first_order_balance(s);
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
