#include "gyromode/modes/isotropic_spectrum.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/partition.h"
#include "gyromode/sparse/shape_block.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace gyromode {

namespace {

constexpr Index most_listed = 300;  // modes of negative energy, whatever the window

SparseMatrices standing(const SparseSystem& system, const sparse::Isotropy& isotropy) {
  SparseMatrices m;
  m.mass = isotropy.mass;
  m.stiffness = isotropy.stiffness;
  m.gyroscopic.resize(m.mass.rows(), m.mass.cols());
  m.gyroscopic_bound = 0;
  std::map<int, int> nodes;
  for (const Index i : isotropy.x)
    m.node.push_back(nodes.try_emplace(system.node()[static_cast<std::size_t>(i)], static_cast<int>(nodes.size())).first->second);
  return m;
}

// s where a root of the window comes from, merged, ascending.
std::vector<Window> of_standing_axes(const Window& w, double spin) {
  std::vector<Window> all;
  for (const Window& s : {Window{w.a - spin, w.b - spin}, Window{spin - w.b, spin - w.a}, Window{spin + w.a, spin + w.b}}) {
    const double a = std::max(s.a, 0.0);
    if (!(s.b > a)) continue;
    all.push_back({a, s.b});
  }
  std::sort(all.begin(), all.end(), [](const Window& a, const Window& b) { return a.a < b.a; });
  std::vector<Window> merged;
  for (const Window& s : all) {
    if (!merged.empty() && s.a <= merged.back().b)
      merged.back().b = std::max(merged.back().b, s.b);
    else
      merged.push_back(s);
  }
  return merged;
}

}  // namespace

IsotropicSpectrum::IsotropicSpectrum(const SparseSystem& system, const sparse::Isotropy& isotropy, const Progress& progress)
    : system_(system),
      isotropy_(isotropy),
      structure_(sparse::analyse(system)),
      groups_(sparse::groups_of(structure_, system.size())),
      standing_(standing(system, isotropy)),
      still_(standing_, progress) {
  const IndexBalance& still = still_.balance();
  if (!still.closed || still.negative > 0 || still.zero > 0) return;
  const Inertia at_spin = still_.inertia_at(isotropy.spin);
  serves_ = !at_spin.doubtful();
  negative_energy_ = at_spin.negative;
}

// z = φ e^{jλt}, λ = ±s − Ω, is X = (φ, −jφ) of λ > 0 and (φ, jφ) of λ < 0; times j where x is in quadrature.
SparseModes IsotropicSpectrum::turned(const Window& range, const Progress& progress) const {
  const double spin = isotropy_.spin;
  struct Root {
    double omega;
    bool forward;  // λ > 0
    Vector shape;
  };
  std::vector<Root> roots;
  for (const Window& w : of_standing_axes(range, spin)) {
    if (number_below(w.b) == number_below(w.a)) continue;
    std::optional<RootRange> found = still_.roots_before_counts(w, progress);
    if (!found) found = still_.roots(w, progress);
    if (found->known_from > w.a || found->known_below < w.b) throw Interrupted();
    for (std::size_t k = 0; k < found->roots.size(); ++k) {
      const double s = found->roots[k].omega;
      if (!w.contains(s)) continue;
      for (const auto& [omega, forward] : {std::pair(s + spin, false), std::pair(std::abs(s - spin), s > spin)}) {
        if (range.contains(omega)) roots.push_back({omega, forward, found->mode(k, true).shape.real()});
      }
    }
  }
  std::sort(roots.begin(), roots.end(), [](const Root& a, const Root& b) { return a.omega < b.omega; });
  const auto m = static_cast<Index>(roots.size());
  sparse::ShapeBlock block{Vector(m), Matrix::Zero(system_.size(), m), Matrix::Zero(system_.size(), m)};
  for (Index k = 0; k < m; ++k) {
    const Root& root = roots[static_cast<std::size_t>(k)];
    block.omega(k) = root.omega;
    for (std::size_t i = 0; i < isotropy_.x.size(); ++i) {
      const double phi = root.shape(static_cast<Index>(i)), across = root.forward ? -phi : phi;
      const bool turned = groups_.partition && groups_.across[static_cast<std::size_t>(isotropy_.x[i])];
      (turned ? block.im : block.re)(isotropy_.x[i], k) = phi;
      (turned ? block.re : block.im)(isotropy_.y[i], k) = turned ? -across : across;
    }
  }
  return measured(system_, groups_, sparse::norms_of(system_), block, block.omega);
}

RootRange IsotropicSpectrum::roots(const Window& range, const Progress& progress) const {
  if (range.open()) throw InvalidArgument(why_an_end() + "a window with two ends or the number of lowest ones is needed");
  const auto kept = std::make_shared<const SparseModes>(turned(range, progress));
  RootRange r;
  for (const sparse::RitzMode& m : *kept) r.roots.push_back({m.omega, error_of(m), m.energy_sign, false, false, ""});
  r.mode = [this, kept](std::size_t i, bool with_shape) { return mode_of(system_, (*kept)[i], with_shape); };
  return r;
}

// A window from 0 that holds some more, by counts: their number grows about as ω does.
std::optional<RootRange> IsotropicSpectrum::lowest_roots(Index count, const Window& range, const Progress& progress) const {
  if (range.a > 0) return std::nullopt;
  constexpr int attempts = 60;
  constexpr Index spare = 4, half = spare / 2;
  constexpr double step = 30;
  const Index wanted = std::min(count + spare, system_.size()), enough = wanted + std::max(wanted / 2, spare);
  const double highest = std::sqrt(standing_.stiffness().diagonal().cwiseQuotient(standing_.mass().diagonal()).maxCoeff());
  double low = 0, high = infinity, b = highest * static_cast<double>(wanted) / static_cast<double>(system_.size());
  for (int k = 0; k < attempts; ++k) {
    const Index there = below(b);
    if (there >= wanted && (there <= enough || high < low * (1 + 1e-6))) break;
    (there < wanted ? low : high) = b;
    const double guess =
        b * std::clamp(static_cast<double>(wanted + half) / static_cast<double>(std::max<Index>(there, 1)), 1 / step, step);
    const bool inside = guess > low * 1.001 && guess < high * 0.999;
    b = inside ? guess : low == 0 ? high / step : high == infinity ? low * step : std::sqrt(low * high);
  }
  b = std::min(b, range.b);
  while (b < range.b && inertia_at(b).doubtful()) b *= 1 + 1e-6;
  RootRange r = roots({0, b}, progress);
  r.all_below = b;
  return r;
}

Index IsotropicSpectrum::below(double omega) const {
  const double spin = isotropy_.spin;
  const Index other = number_below(std::abs(spin - omega));
  return number_below(spin + omega) + (omega < spin ? -other : other);
}

Index IsotropicSpectrum::missed_by_signs(const Window& range) const {
  const double spin = isotropy_.spin;
  return 2 * (number_below(spin - range.a) - number_below(spin - range.b));
}

Inertia IsotropicSpectrum::inertia_at(double omega) const {
  Inertia i = still_.inertia_at(omega + isotropy_.spin);
  const double other = std::abs(omega - isotropy_.spin);
  if (other > 0) {
    const Inertia second = still_.inertia_at(other);
    i.negative += second.negative;
    i.margin = std::min(i.margin, second.margin);
  }
  i.positive = system_.size() - i.negative;
  return i;
}

IndexBalance IsotropicSpectrum::balance() const {
  IndexBalance b;
  b.negative = 2 * negative_energy_;
  b.negative_energy = negative_energy_;
  return b;
}

void IsotropicSpectrum::describe(ModesResult& r, bool with_shapes) const {
  r.structure = system_.basis() ? system_.basis()->given : structure_;
  r.stiffness = {2 * negative_energy_, 0};
  r.solver =
      "sparse: isotropic about the axis of the spin: block Lanczos in axes that stand still, of order n/2; counts by LDLᵀ there (MUMPS)";
  r.opposite_gap = infinity;
  r.stability = negative_energy_ > 0 ? Stability::gyroscopically_stabilised : Stability::stable;
  if (negative_energy_ == 0 || negative_energy_ > most_listed) return;
  for (const sparse::RitzMode& m : turned({0, isotropy_.spin}, {})) {
    if (m.energy_sign < 0) r.negative_modes.push_back(mode_of(system_, m, with_shapes));
  }
}

}  // namespace gyromode
