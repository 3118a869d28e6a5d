#include "gyromode/certificate/verdict.h"

#include "gyromode/certificate/energy_signs.h"
#include "gyromode/certificate/exhibits.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

namespace {

IndexBalance balance_of(const Spectrum& s, const EnergySigns& signs) {
  IndexBalance b;
  b.negative = s.stiffness_negative;
  b.real_pairs = s.divergent();
  b.quadruples = s.fluttering();
  b.negative_energy = std::count(signs.sign.begin(), signs.sign.end(), -1) + signs.undecided_pairs;
  b.zero = s.zero_pairs();
  b.zero_negative = s.stiffness_negative - s.reduced_negative;
  return b;
}

// Why the roots found do not account for everything; empty where they do.
std::string open_reason(const Spectrum& s, const IndexBalance& b, const Exhibits& shown) {
  if (!s.omega.allFinite() || !(s.omega.array() > 0).all()) return "a root far below the largest was lost";
  const Index found = s.omega.size() + b.zero + b.real_pairs + 2 * b.quadruples;
  if (found != s.size()) return fmt::format("{} of {} roots were found", found, s.size());
  if (s.rank_doubtful) return "the rank of K, or of what G makes of its null space, is not decided: a pivot comes within rounding of zero";
  const Index exhibited_index = b.real_pairs + 2 * b.quadruples + 2 * b.negative_energy;
  if (s.reduced_negative != exhibited_index)
    return fmt::format("K has {} negative eigenvalues where the roots found account for {}", s.reduced_negative, exhibited_index);
  return shown.reason;
}

// Every pair of roots of I q̇ + G q = 0 is a mode or two constant solutions.
IndexBalance first_order_balance(const Spectrum& s) {
  IndexBalance b;
  b.zero = s.zero_pairs();
  b.closed = s.size() == 2 * s.omega.size() + s.zero_pairs();
  return b;
}

// A verdict is worth what its balance is worth: roots that do not account for everything leave room for another one.
Stability stability_of(const Spectrum& s, const Verdict& v, bool undecided) {
  if (!v.balance.closed) return Stability::unknown;
  if (s.stiffness_negative == 0) return Stability::stable;
  if (s.unstable.count() > 0) return Stability::unstable;
  if (undecided || s.zero_pairs() > 0) return Stability::marginal;
  return Stability::gyroscopically_stabilised;
}

}  // namespace

Verdict verdict_on(const Impedance& h, const Spectrum& s, Assessment& a) {
  const EnergySigns signs = energy_signs(h, s, a);
  Verdict v;
  v.energy_sign = signs.sign;
  v.gap = signs.gap;
  if (h.second_order()) {
    v.balance = balance_of(s, signs);
    // With K ≥ 0 there is nothing off the axis, counts are plain counts and shapes orthogonal: in a large system that
    // is enough.
    constexpr Index costs_nothing = 64;
    Exhibits shown;
    if (s.stiffness_negative > 0 || s.size() <= costs_nothing) shown = exhibited(h, s, a);
    v.all_shown = shown.all && (s.stiffness_negative > 0 || s.size() <= costs_nothing);
    v.unstable_shown = shown.unstable;
    v.unstable_shown.resize(static_cast<std::size_t>(s.unstable.count()), false);
    v.reason = open_reason(s, v.balance, shown);
    v.balance.closed = v.reason.empty();
  } else {
    v.balance = first_order_balance(s);
    if (!v.balance.closed) v.reason = "the modes and constant solutions found do not make up the order of the system";
  }
  v.stability = stability_of(s, v, signs.undecided_pairs > 0);
  return v;
}

}  // namespace gyromode
