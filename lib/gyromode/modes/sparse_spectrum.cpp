#include "gyromode/modes/sparse_spectrum.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/shape.h"
#include "gyromode/modes/sparse_lowest.h"
#include "gyromode/modes/sparse_slices.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode {

SparseSpectrum::SparseSpectrum(const SparseSystem& system, const Progress& progress)
    : system_(system),
      structure_(sparse::analyse(system)),
      searches_((progress.stage("factorisation of K"), system), structure_),
      balance_(system, searches_, progress),
      counts_(system, searches_, balance_) {
  if (balance_.index().closed) searches_.know({balance_.negative(), balance_.unstable()});
}

// Where all of it is proved the counts at the ends of the window need no work; else they decide.
std::optional<RootRange> SparseSpectrum::roots_before_counts(const Window& range, const Progress& progress) const {
  SparseSlices slices(system_, searches_, balance_, counts_, progress);
  if (!slices.serve(range)) return std::nullopt;
  std::optional<SparseSlices::Found> found = slices.about_middles(range);
  if (!found) return std::nullopt;
  if (found->stopped) {
    RootRange part = range_of(std::move(found->modes), false);
    part.known_from = found->stopped->a;
    part.known_below = found->stopped->b;
    return part;
  }
  if (counts_.known().a <= range.a && counts_.known().b >= range.b) return range_of(std::move(found->modes), false);
  candidates_ = std::move(found->modes);
  return std::nullopt;
}

RootRange SparseSpectrum::roots(const Window& range, const Progress& progress) const {
  if (range.open()) throw InvalidArgument(why_an_end() + "a window with two ends or the number of lowest ones is needed");
  const Index expected = counts_.between(range.a, range.b);
  const auto inside = [&](const sparse::RitzMode& m) { return range.contains(m.omega); };
  if (std::count_if(candidates_.begin(), candidates_.end(), inside) == expected) return range_of(std::move(candidates_), range.a == 0);
  SparseWindows windows(searches_, counts_, progress);
  RootRange all = range_of(windows.between(range.a, range.b, expected), range.a == 0);
  all.known_below = windows.known_below();
  return all;
}

std::optional<RootRange> SparseSpectrum::lowest_roots(Index count, const Window& range, const Progress& progress) const {
  if (range.a > 0) return std::nullopt;
  SparseLowest::Found found = SparseLowest(system_, searches_, balance_, counts_, progress).lowest(count, range);
  RootRange all = range_of(std::move(found.modes), true);
  all.all_below = found.all_below;
  all.known_below = found.known_below;
  return all;
}

RootRange SparseSpectrum::range_of(SparseModes modes, bool from_zero) const {
  const auto kept = std::make_shared<const SparseModes>(std::move(modes));
  const Index zero = from_zero ? zero_roots() : 0;
  RootRange r;
  r.roots.assign(static_cast<std::size_t>(zero), {0, 0, 0, true, rigid(), ""});
  for (const sparse::RitzMode& m : *kept) r.roots.push_back({m.omega, error_of(m), m.energy_sign, false, false, ""});
  r.mode = [this, kept, zero](std::size_t i, bool with_shape) {
    const auto root = static_cast<Index>(i);
    return root < zero ? zero_mode(root, with_shape) : mode_of(system_, (*kept)[i - static_cast<std::size_t>(zero)], with_shape);
  };
  return r;
}

Mode SparseSpectrum::zero_mode(Index which, bool with_shape) const {
  const sparse::FreeMotions& free = searches_.free();
  Mode mode;
  mode.energy_sign = 0;
  mode.kind = rigid() ? ModeKind::rigid_body : ModeKind::vibration;
  Vector shape;
  if (which < free.drift.cols()) {
    shape = free.drift.col(which);
  } else {  // one for every pair that G couples
    Index left = which - free.drift.cols(), k = 0;
    while (free.drifts[static_cast<std::size_t>(k)] || left-- > 0) ++k;
    shape = free.n.col(k);
  }
  mode.residual = sparse::symmetric_times(system_.stiffness(), shape).norm() / (searches_.norms().k * shape.norm());
  if (with_shape) mode.shape = normalised(sparse::in_given(system_, shape.cast<Complex>()));
  return mode;
}

void SparseSpectrum::describe(ModesResult& r, bool with_shapes) const {
  r.structure = system_.basis() ? system_.basis()->given : structure_;
  r.stiffness = {balance_.index().negative, searches_.free().nullity()};
  r.solver =
      fmt::format("sparse: {}{}; counts by LDLᵀ of {} (MUMPS)", system_.basis() ? system_.basis()->in_words + ", " : "",
                  searches_.in_words(), searches_.groups().partition ? "H*, real of order n" : "H(ω) in real arithmetic of order 2n");
  r.opposite_gap = infinity;
  r.stability = !balance_.index().closed                ? Stability::unknown
                : !balance_.unstable().empty()          ? Stability::unstable
                : balance_.index().negative == 0        ? Stability::stable
                : balance_.index().zero > 0 && !rigid() ? Stability::marginal
                                                        : Stability::gyroscopically_stabilised;
  for (const sparse::RitzMode& m : balance_.negative()) r.negative_modes.push_back(mode_of(system_, m, with_shapes));
  for (const sparse::RitzUnstable& u : balance_.unstable()) {
    r.unstable.push_back({u.lambda.real(), u.lambda.imag(), u.residual, u.error_bound, {}});
    if (with_shapes) r.unstable.back().shape = normalised(sparse::in_given(system_, u.shape));
  }
}

}  // namespace gyromode
