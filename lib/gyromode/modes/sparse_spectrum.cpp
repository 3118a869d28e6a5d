#include "gyromode/modes/sparse_spectrum.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode {

namespace {

using sparse::RitzMode;
using sparse::RitzUnstable;
using sparse::Search;

// The least |xᴴHx| over |x|ᵀ|H||x| that two steps of inverse iteration with the factored H find: how far from singular.
double margin_of(const SparseSystem& s, sparse::ShiftedImpedance& h) {
  if (h.singular()) return 0;
  const Index n = s.size();
  const double w = h.shift();
  std::mt19937_64 bits(7);
  ComplexMatrix x(n, 2);
  for (Index k = 0; k < x.size(); ++k) x.data()[k] = std::ldexp(static_cast<double>(bits() >> 11), -52) - 1;
  for (int step = 0; step < 3; ++step) {
    x = h.solve(step == 0 ? x
                          : ComplexMatrix(sparse::symmetric_times(s.mass(), x.real()).cast<Complex>() +
                                          Complex(0, 1) * sparse::symmetric_times(s.mass(), x.imag())));
    for (Index j = 0; j < x.cols(); ++j) {
      if (!x.col(j).allFinite()) return 0;
      x.col(j) /= x.col(j).norm();
    }
  }
  double least = infinity;
  for (Index j = 0; j < x.cols(); ++j) {
    Matrix parts(n, 2);
    parts << x.col(j).real(), x.col(j).imag();
    const Matrix k = sparse::symmetric_times(s.stiffness(), parts), m = sparse::symmetric_times(s.mass(), parts),
                 g = sparse::skew_times(s.gyroscopic(), parts);
    const auto joined = [](const Matrix& a) { return ComplexVector(a.col(0) + Complex(0, 1) * a.col(1)); };
    const ComplexVector hx = joined(k) - w * w * joined(m) + Complex(0, w) * joined(g);
    least = std::min(
        least, std::abs(x.col(j).dot(hx)) / (sparse::size_of(s.stiffness(), x.col(j)) + w * sparse::size_of(s.gyroscopic(), x.col(j)) +
                                             w * w * sparse::size_of(s.mass(), x.col(j))));
  }
  return least;
}

constexpr double worst_residual = 1e-10;    // of a root that is listed
constexpr double singular = 1e3 * epsilon;  // of that margin (theory sparse §1)

// No root beyond what a Krylov space of this width holds is looked for at one shift.
constexpr Index most_at_one_shift = 60;
Index widest(Index wanted) { return 160 + 8 * wanted; }

}  // namespace

SparseSpectrum::SparseSpectrum(const SparseSystem& system, const Progress& progress)
    : system_(system), structure_(sparse::analyse(system)), norms_(sparse::norms_of(system)), impedance_(system, structure_) {
  progress.stage("factorisation of K");
  stiffness_negative_ = impedance_.factor(0);
  if (!(margin_of(system_, impedance_) > singular))
    throw NotApplicable(
        "K is singular to rounding: sparse models with rigid-body motions are not served yet; hold them, or add soft springs");
  at_zero_ = std::make_unique<Search>(system_, impedance_, norms_, 0);
  balance_.negative = stiffness_negative_;
  close_balance(progress);
}

// n₋(K) = k_r + 2k_c + 2k₋ with roots that were shown to exist.
void SparseSpectrum::close_balance(const Progress& progress) {
  balance_.closed = stiffness_negative_ == 0;
  if (balance_.closed) return;
  const auto take = [&](const Search::Found& f) {
    negative_.clear();
    unstable_.clear();
    for (const RitzMode& m : f.modes) {
      if (m.energy_sign < 0 && Search::converged(m)) negative_.push_back(m);
    }
    constexpr double shown = 10;
    for (const RitzUnstable& u : f.unstable) {
      if (u.residual <= 1e-11 && u.lambda.real() > shown * u.error_bound) unstable_.push_back(u);
    }
    balance_.real_pairs = std::count_if(unstable_.begin(), unstable_.end(), [](const RitzUnstable& u) { return u.lambda.imag() == 0; });
    balance_.quadruples = static_cast<Index>(unstable_.size()) - balance_.real_pairs;
    balance_.negative_energy = static_cast<Index>(negative_.size());
    balance_.closed = balance_.real_pairs + 2 * balance_.quadruples + 2 * balance_.negative_energy == stiffness_negative_;
    return balance_.closed;
  };
  take(at_zero_->until(take, infinity, widest(stiffness_negative_), progress));
}

std::string SparseSpectrum::open_reason() const {
  return fmt::format("the index balance does not close: of n₋(K) = {} the motions found near ω = 0 make {}", stiffness_negative_,
                     balance_.real_pairs + 2 * balance_.quadruples + 2 * balance_.negative_energy);
}

Inertia SparseSpectrum::inertia_at(double omega) const {
  const auto known = counted_.find(omega);
  if (known != counted_.end()) return known->second;
  at_zero_.reset();  // its factorisation makes room
  Inertia i;
  i.negative = impedance_.factor(omega);
  i.positive = system_.size() - i.negative;
  i.margin = margin_of(system_, impedance_) > singular ? 1 : 0;
  return counted_.emplace(omega, i).first->second;
}

Index SparseSpectrum::missed_by_signs(const Window& range) const {
  return 2 * std::count_if(negative_.begin(), negative_.end(), [&](const RitzMode& m) { return range.contains(m.omega); });
}

Index SparseSpectrum::expected_in(double a, double b) const {
  const Index low = a > 0 ? inertia_at(a).negative : stiffness_negative_;
  return inertia_at(b).negative - low + missed_by_signs({a, b});
}

Index SparseSpectrum::below(double omega) const { return omega > 0 ? expected_in(0, omega) : 0; }

// As many as are counted, all converged; wide windows in parts.
SparseSpectrum::Modes SparseSpectrum::between(double a, double b, Index expected, const Progress& progress) const {
  if (expected <= 0) return {};
  constexpr double narrowest = 1e-6;
  if (expected > most_at_one_shift && b - a > narrowest * b) {
    double middle = 0.5 * (a + b);
    for (int attempt = 0; inertia_at(middle).doubtful() && attempt < 8; ++attempt) middle += 0.01 * (b - a);
    Modes all = between(a, middle, expected_in(a, middle), progress);
    for (RitzMode& m : between(middle, b, expected_in(middle, b), progress)) all.push_back(std::move(m));
    return all;
  }
  const auto inside = [&](const RitzMode& m) { return m.omega >= a && m.omega < b; };
  const auto enough = [&](const Search::Found& f) {
    return std::count_if(f.modes.begin(), f.modes.end(), [&](const RitzMode& m) { return inside(m) && Search::converged(m); }) >= expected;
  };
  progress.stage("factorisation at the shift");
  double sigma = a > 0 ? 0.5 * (a + b) : 0;
  for (int attempt = 0; attempt < 8; ++attempt) {  // one on a mode is moved
    impedance_.factor(sigma);
    if (sigma == 0 || margin_of(system_, impedance_) > singular) break;
    sigma += 0.013 * (b - a);
  }
  Search search(system_, impedance_, norms_, sigma);
  Search::Found f = search.until(enough, b, widest(expected), progress);
  Modes all;
  for (RitzMode& m : f.modes) {  // what has not converged may be none
    if (inside(m) && m.residual <= worst_residual) all.push_back(std::move(m));
  }
  return all;
}

RootRange SparseSpectrum::roots(const Window& range, const Progress& progress) const {
  if (range.open()) throw InvalidArgument(why_an_end() + "a window with two ends or the number of lowest ones is needed");
  return range_of(between(range.a, range.b, expected_in(range.a, range.b), progress));
}

// Until that many and two more have converged about K; the gap after them is counted by the caller.
std::optional<RootRange> SparseSpectrum::lowest_roots(Index count, const Window& range, const Progress& progress) const {
  if (range.a > 0 || count > most_at_one_shift) return std::nullopt;
  if (!at_zero_) at_zero_ = std::make_unique<Search>(system_, impedance_, norms_, 0);
  const auto enough = [&](const Search::Found& f) {
    constexpr Index more = 2;
    Index good = 0;
    for (const RitzMode& m : f.modes) {
      if (!Search::converged(m)) break;
      ++good;
    }
    return good >= count + more;
  };
  Search::Found f = at_zero_->until(enough, range.b, widest(count), progress);
  Modes all;
  for (RitzMode& m : f.modes) {
    if (!Search::converged(m)) break;  // beyond, some may be missing
    all.push_back(std::move(m));
  }
  return range_of(std::move(all));
}

RootRange SparseSpectrum::range_of(Modes modes) const {
  const auto kept = std::make_shared<const Modes>(std::move(modes));
  RootRange r;
  for (std::size_t k = 0; k < kept->size(); ++k) {
    const RitzMode& m = (*kept)[k];
    r.roots.push_back({m.omega, std::max(m.error_bound, 4 * epsilon * m.omega), m.energy_sign, false, false, ""});
  }
  r.mode = [this, kept](std::size_t i, bool with_shape) { return mode_of((*kept)[i], with_shape); };
  return r;
}

Mode SparseSpectrum::mode_of(const RitzMode& m, bool with_shape) const {
  Mode mode;
  mode.omega = m.omega;
  mode.energy_sign = m.energy_sign;
  mode.residual = m.residual;
  mode.error_bound = m.error_bound;
  if (with_shape) {
    mode.form = m.form / std::norm(largest_entry(m.shape));
    mode.shape = normalised(m.shape);
  }
  return mode;
}

void SparseSpectrum::describe(ModesResult& r, bool with_shapes) const {
  r.structure = structure_;
  r.stiffness = {stiffness_negative_, 0};
  r.solver = fmt::format("sparse: block Krylov about K and shifts, projected; counts by LDLᵀ of {} (MUMPS)",
                         impedance_.quadrature() ? "H*, real of order n" : "H(ω) in real arithmetic of order 2n");
  r.opposite_gap = infinity;
  r.stability = !balance_.closed     ? Stability::unknown
                : !unstable_.empty() ? Stability::unstable
                : negative_.empty()  ? Stability::stable
                                     : Stability::gyroscopically_stabilised;
  for (const RitzMode& m : negative_) r.negative_modes.push_back(mode_of(m, with_shapes));
  for (const RitzUnstable& u : unstable_) {
    r.unstable.push_back({u.lambda.real(), u.lambda.imag(), u.residual, u.error_bound, {}});
    if (with_shapes) r.unstable.back().shape = normalised(u.shape);
  }
}

}  // namespace gyromode
