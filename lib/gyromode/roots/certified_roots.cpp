#include "gyromode/roots/certified_roots.h"

#include "gyromode/roots/unstable_root.h"
#include "gyromode/roots/negative_energy.h"

#include <algorithm>
#include <cmath>

namespace gyromode {

CertifiedRoots::CertifiedRoots(const LiftedImpedance& impedance, const std::vector<Index>& free, const std::vector<Index>& cyclic,
                               Index zeros, const SeedSource& seeds)
    : blocked_(impedance), static_(static_count(blocked_, free, cyclic, zeros)) {
  if (!indefinite()) return;
  for (Index b = 0; b < static_cast<Index>(blocked_.blocks.size()); ++b) {
    if (missing(b) <= 0) continue;
    for (UnstableRoot& g : divergences(blocked_, b)) {
      measure(blocked_, g);
      growing_.push_back(g);
    }
    if (missing(b) > 0) add(falls(blocked_, b, samples_of_all_decades()));
  }
  for (Index attempt = 0; !closed(); ++attempt) {
    const std::optional<Seeds> given = seeds(attempt);
    if (!given) return;
    asked_for_seeds_ = true;
    find_growing(given->growing);
    find_negative(given->negative_energy);
  }
}

bool CertifiedRoots::indefinite() const {
  return std::any_of(static_.reduced.begin(), static_.reduced.end(), [](Index n) { return n > 0; });
}

// Of k_r + 2k_c + 2k₋ of a block.
Index CertifiedRoots::missing(Index block) const {
  Index left = static_.reduced[static_cast<std::size_t>(block)];
  for (const UnstableRoot& g : growing_) left -= g.block != block ? 0 : g.omega > 0 ? 2 : 1;
  for (const Root& r : negative_) left -= r.block == block ? 2 : 0;
  return left;
}

bool CertifiedRoots::closed() const {
  if (static_.doubtful) return false;
  for (Index b = 0; b < static_cast<Index>(blocked_.blocks.size()); ++b) {
    if (missing(b) != 0) return false;
  }
  return true;
}

// Those of negative energy that are not known yet.
void CertifiedRoots::add(std::vector<Root> negative) {
  for (Root& root : negative) {
    const bool known = std::any_of(negative_.begin(), negative_.end(), [&](const Root& r) {
      return r.block == root.block && std::abs(r.omega - root.omega) <= 4 * (r.error + root.error) + 1e-14 * root.omega;
    });
    if (!known && root.energy_sign < 0) negative_.push_back(std::move(root));
  }
  std::sort(negative_.begin(), negative_.end(), [](const Root& a, const Root& b) { return a.omega < b.omega; });
}

// Where J falls near the seed is a mode of negative energy, whatever the seed was.
void CertifiedRoots::find_negative(const std::vector<double>& seeds) {
  for (const double seed : seeds) {
    for (Index b = 0; b < static_cast<Index>(blocked_.blocks.size()); ++b) {
      if (missing(b) > 0) add(falls(blocked_, b, samples_around(seed)));
    }
  }
}

void CertifiedRoots::find_growing(const std::vector<Complex>& seeds) {
  for (const Complex& seed : seeds) {
    for (std::size_t b = 0; b < blocked_.blocks.size(); ++b) {
      if (missing(static_cast<Index>(b)) <= 0) continue;
      const auto root = unstable_root(blocked_, static_cast<Index>(b), seed);
      if (!root) continue;
      const auto same = [&](const UnstableRoot& g) {
        return g.block == root->block &&
               std::abs(Complex(g.growth - root->growth, g.omega - root->omega)) <= 1e-7 * std::abs(Complex(g.growth, g.omega));
      };
      if (std::none_of(growing_.begin(), growing_.end(), same)) growing_.push_back(*root);
    }
  }
}

Index CertifiedRoots::growing_count(Index block, double omega, Index count) const {
  if (omega == 0) return static_.count[static_cast<std::size_t>(block)];
  Index passed = 0;
  for (const Root& r : negative_) passed += r.block == block && r.omega < omega ? 1 : 0;
  return count + 2 * passed;
}

RootsBetween CertifiedRoots::between(double a, double b, const Progress& progress) const {
  const MonotoneCount growing = [this](Index block, double omega, Index count) { return growing_count(block, omega, count); };
  RootsBetween found;
  std::vector<Root>& roots = found.roots;
  const Index all = progress.tell ? below(b) - below(a) : 0;
  const bool done = isolate(blocked_, a, b, growing, [&](const Bracket& bracket) {
    if (progress.stopped()) {
      found.known_below = bracket.lo;
      return false;
    }
    for (Root& r : converge(blocked_, bracket)) roots.push_back(std::move(r));
    progress.report("modes", static_cast<Index>(roots.size()), all);
    return true;
  });
  // Brackets come by their lower ends, and one of another block may reach beyond: what is above the place of stopping
  // is not all.
  if (!done) std::erase_if(roots, [&](const Root& r) { return r.omega >= found.known_below; });
  std::stable_sort(roots.begin(), roots.end(), [](const Root& x, const Root& y) { return x.omega < y.omega; });
  return found;
}

Index CertifiedRoots::below(double omega) const {
  const Lifted lifted = blocked_.impedance.at(omega);
  Index sum = 0;
  for (std::size_t b = 0; b < blocked_.blocks.size(); ++b) {
    const Index now = growing_count(static_cast<Index>(b), omega, state_of(blocked_.blocks[b], lifted).count);
    sum += (now - static_.count[b]) * blocked_.blocks[b].copies();
  }
  return sum;
}

Inertia CertifiedRoots::inertia_at(double omega) const {
  const Lifted lifted = blocked_.impedance.at(omega);
  constexpr double beyond_doubt = 64;  // far more than the errors of roots found: no root found below such an end is counted above it
  const double limit = beyond_doubt * blocked_.impedance.rounding(omega);
  Inertia sum;
  for (const Block& b : blocked_.blocks) {
    const BlockState s = state_of(b, lifted);
    sum.negative += s.count * b.copies();
    if (std::abs(s.nearest) <= limit * s.size) sum.margin = 0;
  }
  return sum;
}

}  // namespace gyromode
