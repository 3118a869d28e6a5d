#include "gyromode/modes/sparse_spectrum.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/resting.h"
#include "gyromode/sparse/subspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

using sparse::converged;
using sparse::RitzMode;
using sparse::RitzUnstable;
using sparse::Search;

constexpr double worst_residual = 1e-10;  // of a root that is listed
constexpr Index most_at_one_shift = 60;
constexpr Index most_negative = 300;  // of n₋(K): so many motions are looked for, one by one

// Columns after which a search is given up: some thirty for every root, and what a bad start takes.
Index most_applied(Index wanted) {
  constexpr Index start = 1200, each = 30;
  return start + each * wanted;
}

Matrix parts_of(const ComplexVector& shape) {
  Matrix parts(shape.size(), 2);
  parts << shape.real(), shape.imag();
  return parts;
}

Index converged_in(const std::vector<Search::Expected>& inside) {
  return std::count_if(inside.begin(), inside.end(), [](const auto& e) { return e.converged; });
}

// Converged from one end on, without one between that has not.
template <class Iterator>
Index converged_from(Iterator first, Iterator last) {
  return std::find_if(first, last, [](const auto& e) { return !e.converged; }) - first;
}

std::optional<Window> wanted_if(bool enough, const Window& range) { return enough ? std::optional<Window>(range) : std::nullopt; }

void keep_listable(std::vector<RitzMode>& modes) {  // what has not converged may be none
  modes.erase(std::remove_if(modes.begin(), modes.end(), [](const RitzMode& m) { return !(m.residual <= worst_residual); }), modes.end());
}

}  // namespace

SparseSpectrum::SparseSpectrum(const SparseSystem& system, const Progress& progress)
    : system_(system), structure_(sparse::analyse(system)), searches_((progress.stage("factorisation of K"), system), structure_) {
  if (!(searches_.stiffness().margin() > sparse::singular_margin))
    throw NotApplicable(
        "K is singular to rounding: sparse models with rigid-body motions are not served yet; hold them, or add soft springs");
  balance_.negative = searches_.stiffness().negative();
  close_balance(progress);
}

// n₋(K) = k_r + 2k_c + 2k₋ with roots that were shown to exist. Motions of negative energy have ω < γ/2, γ ≥
// ‖M^−½GM^−½‖, as 2ω XᴴMX < Xᴴ(jG)X: where what is near 0 does not close the balance, shifts up to there are tried. Of
// searches that found the same motion one remains, by a projection on the shapes of all.
void SparseSpectrum::close_balance(const Progress& progress) {
  const Index negative = balance_.negative;
  balance_.closed = negative == 0;
  if (balance_.closed || negative > most_negative) return;
  sparse::Subspace shapes(system_, searches_.groups().across, searches_.groups().partition);
  bool first = true;
  const auto take = [&](const Search::Found& f) {
    negative_.clear();
    unstable_.clear();
    for (const RitzMode& m : f.modes) {
      if (m.energy_sign < 0 && converged(m)) negative_.push_back(m);
    }
    constexpr double shown = 10;
    for (const RitzUnstable& u : f.unstable) {
      if (u.residual <= 1e-11 && u.lambda.real() > shown * u.error_bound) unstable_.push_back(u);
    }
    balance_.real_pairs = std::count_if(unstable_.begin(), unstable_.end(), [](const RitzUnstable& u) { return u.lambda.imag() == 0; });
    balance_.quadruples = static_cast<Index>(unstable_.size()) - balance_.real_pairs;
    balance_.negative_energy = static_cast<Index>(negative_.size());
    balance_.closed = balance_.real_pairs + 2 * balance_.quadruples + 2 * balance_.negative_energy == negative;
    return balance_.closed || !first;
  };
  const auto keep = [&] {
    for (const RitzMode& m : negative_) shapes.add(parts_of(m.shape));
    for (const RitzUnstable& u : unstable_) shapes.add(parts_of(u.shape));
  };
  const double farthest = 0.5 * system_.gyroscopic_bound().value_or(gyroscopic_size());
  sparse::Goal goal;
  if (system_.gyroscopic_bound()) goal.range.b = farthest;  // none is beyond
  goal.enough = [&](const auto&) { return std::optional<Window>(goal.range); };
  goal.accepted = take;
  goal.missing = negative;
  goal.most_applied = most_applied(negative);
  at_zero_ = searches_.about(0, negative + 8);
  take(search_for(*at_zero_, goal, progress));
  for (const double part : {0.5, 0.25, 0.75, 1.0}) {
    if (balance_.closed || !(farthest > 0)) return;
    if (first) keep();
    first = false;
    const auto search = searches_.about(part * farthest, negative + 8);
    goal.most_applied = most_applied(negative) / 4;
    goal.accepted = nullptr;
    goal.enough = [](const auto&) { return std::optional<Window>(); };
    take(search_for(*search, goal, progress));
    keep();
    take(measured_in(system_, searches_.norms(), shapes, {}));
  }
}

// About ‖M^−½GM^−½‖, by its entries.
double SparseSpectrum::gyroscopic_size() const {
  const Vector root = system_.mass().diagonal().cwiseSqrt().cwiseInverse();
  return sparse::norm1(SparseMatrix(root.asDiagonal() * system_.gyroscopic() * root.asDiagonal()));
}

std::string SparseSpectrum::open_reason() const {
  if (balance_.negative > most_negative)
    return fmt::format("n₋(K) = {}: the motions that take so many negative directions are not looked for beyond {}", balance_.negative,
                       most_negative);
  return fmt::format("the index balance does not close: of n₋(K) = {} the motions found near ω = 0 make {}", balance_.negative,
                     balance_.real_pairs + 2 * balance_.quadruples + 2 * balance_.negative_energy);
}

Inertia SparseSpectrum::inertia_at(double omega) const {
  Inertia i;
  if (omega <= known_below_) {  // between roots that are all there are
    i.margin = 1;
    for (const CountedRoot& r : lowest_) {
      if (std::abs(r.omega - omega) <= r.error) i.margin = 0;
      if (r.omega < omega) ++i.negative;
    }
    i.positive = system_.size() - i.negative;
    return i;
  }
  const auto known = counted_.find(omega);
  if (known != counted_.end()) return known->second;
  at_zero_.reset();  // it makes room
  const auto h = searches_.impedance(omega);
  i.negative = h->negative;
  i.positive = system_.size() - i.negative;
  const double rounding = system_.basis() ? 10 * system_.basis()->departure : 0;
  i.margin = h->margin > std::max(sparse::singular_margin, rounding) ? 1 : 0;
  margins_[omega] = h->margin;
  return counted_.emplace(omega, i).first->second;
}

Index SparseSpectrum::missed_by_signs(const Window& range) const {
  return 2 * std::count_if(negative_.begin(), negative_.end(), [&](const RitzMode& m) { return range.contains(m.omega); });
}

Index SparseSpectrum::expected_in(double a, double b) const {
  const Index low = a > 0 ? inertia_at(a).negative : negative_at_zero();
  return inertia_at(b).negative - low + missed_by_signs({a, b});
}

Index SparseSpectrum::below(double omega) const { return omega > 0 ? expected_in(0, omega) : 0; }

double SparseSpectrum::middle_of(double a, double b) const {
  constexpr int attempts = 8;
  double middle = 0.5 * (a + b);
  for (int k = 0; k < attempts && inertia_at(middle).doubtful(); ++k) middle += 0.013 * (b - a);
  return middle;
}

double SparseSpectrum::margin_at(double omega) const {
  const auto known = margins_.find(omega);
  return known != margins_.end() ? known->second : searches_.impedance(omega)->margin;
}

SparseSpectrum::Modes SparseSpectrum::about(double sigma, double a, double b, Index expected, const Progress& progress) const {
  const auto search = searches_.about(sigma, expected);
  sparse::Goal goal;
  goal.range = {a, b};
  goal.enough = [&](const auto& inside) { return wanted_if(converged_in(inside) >= expected, goal.range); };
  goal.missing = expected;
  goal.most_applied = most_applied(expected);
  Modes all = search_for(*search, goal, progress).modes;
  keep_listable(all);
  return all;
}

// Each end, a factorisation there for the counts, finds the half next to it: below a cut between two roots those of the
// lower end are taken, above it those of the upper.
SparseSpectrum::Modes SparseSpectrum::from_both_ends(double a, double b, Index expected, const Progress& progress) const {
  Modes low, high, all;
  const auto joined = [&] {
    std::vector<double> cuts{a, b};
    for (const Modes* side : {&low, &high}) {
      for (const RitzMode& m : *side) cuts.push_back(m.omega);
    }
    std::sort(cuts.begin(), cuts.end());
    const auto below = [](double cut) { return [cut](const RitzMode& m) { return m.omega < cut; }; };
    for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
      constexpr double apart = 1e-9;
      if (k > 0 && cuts[k + 1] - cuts[k] <= apart * cuts[k]) continue;
      const double cut = k == 0 ? a : 0.5 * (cuts[k] + cuts[k + 1]);
      const auto lower = std::partition_point(low.begin(), low.end(), below(cut)),
                 upper = std::partition_point(high.begin(), high.end(), below(cut));
      if ((lower - low.begin()) + (high.end() - upper) != expected) continue;
      all.assign(low.begin(), lower);
      all.insert(all.end(), upper, high.end());
      return true;
    }
    return false;
  };
  constexpr Index beyond = 1;
  Index wanted = (expected + 1) / 2 + beyond;
  sparse::Goal goal;
  goal.range = {a, b};
  goal.missing = wanted;
  goal.most_applied = most_applied(expected);
  goal.enough = [&](const auto& inside) {
    return wanted_if(converged_from(inside.begin(), inside.end()) >= wanted || converged_in(inside) >= expected, goal.range);
  };
  const auto lower = searches_.about(a, expected);
  low = search_for(*lower, goal, progress).modes;
  keep_listable(low);
  if (joined()) return all;
  wanted = std::max<Index>(expected - static_cast<Index>(low.size()), 0) + beyond;
  goal.missing = wanted;
  goal.enough = [&](const auto& inside) {
    return wanted_if(converged_from(inside.rbegin(), inside.rend()) >= wanted || converged_in(inside) >= expected, goal.range);
  };
  high = search_for(*searches_.about(b, expected), goal, progress).modes;
  keep_listable(high);
  if (joined()) return all;
  // No gap to join them at, as where many are equal: all from one end.
  goal.missing = expected;
  goal.enough = [&](const auto& inside) { return wanted_if(converged_in(inside) >= expected, goal.range); };
  low = search_for(*lower, goal, progress).modes;
  keep_listable(low);
  return low.size() > high.size() ? low : high;
}

// Wide windows in parts; narrow ones from both ends, or from a shift of their own where that did not do.
SparseSpectrum::Modes SparseSpectrum::between(double a, double b, Index expected, const Progress& progress, int depth) const {
  if (expected <= 0) return {};
  constexpr double narrowest = 1e-6;
  constexpr double near_a_mode = 1e-9;  // of the margin: a shift as near as that hides the others behind one root
  if (expected > most_at_one_shift && b - a > narrowest * b) {
    const double middle = middle_of(a, b);
    Modes all = between(a, middle, expected_in(a, middle), progress);
    for (RitzMode& m : between(middle, b, expected_in(middle, b), progress)) all.push_back(std::move(m));
    return all;
  }
  const bool ends_serve = a > 0 && margin_at(a) > near_a_mode && margin_at(b) > near_a_mode;
  Modes all = a == 0 ? about(0, a, b, expected, progress) : ends_serve ? from_both_ends(a, b, expected, progress) : Modes();
  if (static_cast<Index>(all.size()) == expected) return all;
  const double middle = middle_of(a, b);
  Modes other = about(middle, a, b, expected, progress);
  if (other.size() > all.size()) all.swap(other);
  if (static_cast<Index>(all.size()) == expected || depth == 0) return all;
  // In halves, as counts say where something is missing.
  other = between(a, middle, expected_in(a, middle), progress, depth - 1);
  for (RitzMode& m : between(middle, b, expected_in(middle, b), progress, depth - 1)) other.push_back(std::move(m));
  return other.size() > all.size() ? other : all;
}

RootRange SparseSpectrum::roots(const Window& range, const Progress& progress) const {
  if (range.open()) throw InvalidArgument(why_an_end() + "a window with two ends or the number of lowest ones is needed");
  return range_of(between(range.a, range.b, expected_in(range.a, range.b), progress));
}

bool SparseSpectrum::close_at_rest(const Modes& lowest, Index wanted, const Progress& progress) const {
  if (balance_.negative > 0 || !system_.gyroscopic_bound() || static_cast<Index>(lowest.size()) <= wanted) return false;
  const double gamma = *system_.gyroscopic_bound();
  const Vector resting = sparse::resting_squares(system_, lowest);
  // At the widest gap where as many modes at rest are expected below as there are modes.
  double best = 0, sigma = 0;
  Index below = 0;
  for (std::size_t k = static_cast<std::size_t>(wanted); k < lowest.size(); ++k) {
    const double from = lowest[k - 1].omega, to = lowest[k].omega, low = from * (from + gamma), high = to * to;
    // μ = σ² + γσ between the modes at rest: none of K − μM is to change its sign before the next one at rest.
    const Index at_rest = std::count_if(resting.begin(), resting.end(), [&](double square) { return square < low; });
    if (at_rest > static_cast<Index>(k)) continue;
    const double next = static_cast<Index>(k) < resting.size() ? resting(static_cast<Index>(k)) : high;
    const double gap = (next - low) / low;
    if (gap <= best) continue;
    best = gap;
    below = static_cast<Index>(k);
    constexpr double inside = 0.05;
    sigma = from + inside * std::min(to - from, (std::sqrt(next + 0.25 * gamma * gamma) - 0.5 * gamma) - from);
  }
  if (below == 0) return false;
  progress.stage("counts of the modes at rest");
  const Index at_rest = sparse::negative_at_rest(system_, searches_.groups(), sigma * (sigma + gamma));
  if (at_rest != below) return false;
  known_below_ = sigma;
  lowest_.clear();
  for (Index k = 0; k < below; ++k) {
    const RitzMode& m = lowest[static_cast<std::size_t>(k)];
    lowest_.push_back({m.omega, std::max(m.error_bound, 4 * epsilon * m.omega), m.energy_sign, false, false, ""});
  }
  return true;
}

// Until that many and some more have converged about K; what is below the gap after them is counted there. Where there
// are more than that, and of many, by windows whose ends are counted.
std::optional<RootRange> SparseSpectrum::lowest_roots(Index count, const Window& range, const Progress& progress) const {
  if (range.a > 0) return std::nullopt;
  constexpr Index more = 4;
  const Index first = std::min(count, most_at_one_shift);
  if (!at_zero_) at_zero_ = searches_.about(0, first + more);
  sparse::Goal goal;
  goal.range = {0, range.b};
  goal.missing = first + more;
  goal.most_applied = most_applied(first);
  double last = 0;  // of those that have converged without one between that has not
  goal.enough = [&](const auto& inside) {
    const Index good = converged_from(inside.begin(), inside.end());
    constexpr double beyond_error = 1 + 1e-6;
    last = good > 0 ? beyond_error * inside[static_cast<std::size_t>(std::min(good, first + more)) - 1].omega : 0;
    return wanted_if(good >= first + more, Window{0, last});
  };
  Search::Found f = search_for(*at_zero_, goal, progress);
  keep_listable(f.modes);
  while (f.modes.size() > 1 && f.modes.back().omega > last) f.modes.pop_back();
  const Modes& low = f.modes;
  if (!balance_.closed) {  // counts say nothing of how many there are
    RootRange some = range_of(low);
    some.all_below = gap_after(low, std::min(count, static_cast<Index>(low.size()) - 1));
    if (some.all_below == 0) throw NotConverged("no mode near 0 has converged: ask for a window, which is searched from its ends");
    return some;
  }
  const std::vector<Search::Expected> expected = at_zero_->look();
  if (low.empty() && expected.empty()) throw NotConverged("no mode near 0 was found: ask for a window, which is searched from its ends");
  double end = low.empty() ? expected.front().omega : low.back().omega;
  if (count <= most_at_one_shift) {
    if (close_at_rest(low, count, progress)) {
      RootRange all = range_of(std::move(f.modes));
      all.all_below = known_below_;
      return all;
    }
    if (static_cast<Index>(low.size()) > count) {
      const double gap = gap_after(low, count);
      if (gap > 0 && expected_in(0, gap) == std::count_if(low.begin(), low.end(), [&](const RitzMode& m) { return m.omega < gap; }))
        return range_of(std::move(f.modes));
    }
  }
  // Farther up until there are as many by count, and back where that was much too far.
  double below = 0;
  end = clear_of_roots(end);
  Index there = expected_in(0, end);
  while (there <= count && end < range.b) {
    constexpr double least = 1.1, most = 2;
    below = end;
    const double wanted = static_cast<double>(count + more) / static_cast<double>(std::max<Index>(there, 1));
    end = std::min(clear_of_roots(end * std::clamp(wanted, least, most)), range.b);
    there = expected_in(0, end);
  }
  constexpr int most_halvings = 40;
  for (int k = 0; k < most_halvings && there > 2 * count + most_at_one_shift; ++k) {
    const double middle = middle_of(below, end);
    const Index in_half = expected_in(0, middle);
    (in_half > count ? end : below) = middle;
    if (in_half > count) there = in_half;
  }
  RootRange all = range_of(between(0, end, there, progress));
  all.all_below = end;
  return all;
}

// The middle of the first gap after `count` of ascending roots that is wider than their errors; 0 where there is none.
double SparseSpectrum::gap_after(const Modes& roots, Index count) const {
  for (std::size_t k = static_cast<std::size_t>(std::max<Index>(count, 1)); k < roots.size(); ++k) {
    const double from = roots[k - 1].omega + 4 * roots[k - 1].error_bound, to = roots[k].omega - 4 * roots[k].error_bound;
    if (to > from) return 0.5 * (from + to);
  }
  return 0;
}

// A frequency a little above that is none of a mode.
double SparseSpectrum::clear_of_roots(double omega) const {
  constexpr int attempts = 8;
  constexpr double step = 1e-5;
  double w = omega * (1 + step);
  for (int k = 1; k < attempts && inertia_at(w).doubtful(); ++k) w = omega * (1 + step * std::exp2(k));
  return w;
}

RootRange SparseSpectrum::range_of(Modes modes, double known_below) const {
  const auto kept = std::make_shared<const Modes>(std::move(modes));
  RootRange r;
  r.known_below = known_below;
  for (std::size_t k = 0; k < kept->size(); ++k) {
    const RitzMode& m = (*kept)[k];
    r.roots.push_back({m.omega, std::max(m.error_bound, 4 * epsilon * m.omega), m.energy_sign, false, false, ""});
  }
  r.mode = [this, kept](std::size_t i, bool with_shape) { return mode_of((*kept)[i], with_shape); };
  return r;
}

ComplexVector SparseSpectrum::in_given(const ComplexVector& shape) const {
  return system_.basis() ? sparse::in_given(*system_.basis(), shape) : shape;
}

Mode SparseSpectrum::mode_of(const RitzMode& m, bool with_shape) const {
  Mode mode;
  mode.omega = m.omega;
  mode.energy_sign = m.energy_sign;
  mode.residual = m.residual;
  mode.error_bound = m.error_bound;
  if (system_.basis()) mode.residual += system_.basis()->departure;
  if (with_shape) {
    const ComplexVector shape = in_given(m.shape);
    mode.form = m.form / std::norm(largest_entry(shape));
    mode.shape = normalised(shape);
  }
  return mode;
}

void SparseSpectrum::describe(ModesResult& r, bool with_shapes) const {
  r.structure = system_.basis() ? system_.basis()->given : structure_;
  r.stiffness = {balance_.negative, 0};
  r.solver =
      fmt::format("sparse: {}{}; counts by LDLᵀ of {} (MUMPS)", system_.basis() ? system_.basis()->in_words + ", " : "",
                  searches_.in_words(), searches_.groups().partition ? "H*, real of order n" : "H(ω) in real arithmetic of order 2n");
  r.opposite_gap = infinity;
  r.stability = !balance_.closed     ? Stability::unknown
                : !unstable_.empty() ? Stability::unstable
                : negative_.empty()  ? Stability::stable
                                     : Stability::gyroscopically_stabilised;
  for (const RitzMode& m : negative_) r.negative_modes.push_back(mode_of(m, with_shapes));
  for (const RitzUnstable& u : unstable_) {
    r.unstable.push_back({u.lambda.real(), u.lambda.imag(), u.residual, u.error_bound, {}});
    if (with_shapes) r.unstable.back().shape = normalised(in_given(u.shape));
  }
}

}  // namespace gyromode
