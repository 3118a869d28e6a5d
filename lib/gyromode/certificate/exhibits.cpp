#include "gyromode/certificate/exhibits.h"

#include "gyromode/base/rounding.h"
#include "gyromode/certificate/measure_unstable.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace gyromode {

namespace {

// One root of the upper right quarter with its disc; `at` is its position among the modes, or among the unstable roots.
struct Disc {
  Complex centre;
  double bound = 0;  // of the error
  // the same, and not more than `widest` of |λ|: where first order says nothing, how far the roots are is left to the
  // count
  double radius = 0;
  bool mode = false;
  Index at = 0;
};

std::vector<Disc> discs_of(const Spectrum& s, const Assessment& a) {
  std::vector<Disc> discs;
  for (Index i = 0; i < s.omega.size(); ++i) discs.push_back({{0, s.omega(i)}, a.error_bound(i), 0, true, i});
  for (Index i = 0; i < s.unstable.count(); ++i)
    discs.push_back({s.unstable.lambda[static_cast<std::size_t>(i)], a.unstable.error_bound(i), 0, false, i});
  constexpr double widest = 1e-4;
  for (Disc& d : discs) d.radius = d.bound <= widest * std::abs(d.centre) ? d.bound : widest * std::abs(d.centre);
  std::sort(discs.begin(), discs.end(), [](const Disc& p, const Disc& q) { return p.centre.imag() < q.centre.imag(); });
  return discs;
}

// Discs whose distance is not above four times the sum of their radii belong together.
std::vector<std::vector<std::size_t>> touching(const std::vector<Disc>& discs) {
  constexpr double apart = 4;
  std::vector<std::size_t> parent(discs.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  double widest = 0;
  for (const Disc& d : discs) widest = std::max(widest, d.radius);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t k = i + 1; k < discs.size(); ++k) {
      if (discs[k].centre.imag() - discs[i].centre.imag() > apart * (discs[i].radius + widest)) break;
      if (std::abs(discs[k].centre - discs[i].centre) <= apart * (discs[i].radius + discs[k].radius)) parent[root(k)] = root(i);
    }
  }
  std::vector<std::vector<std::size_t>> groups(discs.size());
  for (std::size_t i = 0; i < discs.size(); ++i) groups[root(i)].push_back(i);
  std::erase_if(groups, [](const auto& g) { return g.empty(); });
  return groups;
}

// A disc of one root that stands by itself: off both axes if its root is, and not about 0.
bool stands_alone(const Disc& d) {
  constexpr double small_part = 0.1;
  if (d.mode) return d.bound <= small_part * d.centre.imag();
  return d.bound <= small_part * d.centre.real() && (d.centre.imag() == 0 || d.bound <= small_part * d.centre.imag());
}

// The roots of a group with their mirror images, and how near another root comes to them.
struct Surroundings {
  Complex centre;
  double inner = 0;         // of the discs of the group
  double outer = infinity;  // to the nearest other root, image, or 0
  Index roots = 0;          // with the images inside
};

std::vector<Complex> images(const Disc& d) {
  if (d.mode) return {d.centre, std::conj(d.centre)};
  if (d.centre.imag() == 0) return {d.centre, -d.centre};
  return {d.centre, std::conj(d.centre), -d.centre, -std::conj(d.centre)};
}

Surroundings around(const std::vector<Disc>& discs, const std::vector<std::size_t>& group) {
  Surroundings s;
  double radius = 0;
  bool off = true, across = false;  // whether the group stays off the imaginary axis, and whether it meets the real one
  for (const std::size_t i : group) {
    const Disc& d = discs[i];
    s.centre += d.centre / static_cast<double>(group.size());
    radius = std::max(radius, d.radius);
    off = off && !d.mode && d.centre.real() > 4 * d.radius;
    across = across || (!d.mode && d.centre.imag() <= 4 * d.radius);
  }
  if (!off) s.centre = {0, s.centre.imag()};
  if (across) s.centre = {s.centre.real(), 0};
  for (const std::size_t i : group) s.inner = std::max(s.inner, std::abs(discs[i].centre - s.centre) + radius);
  s.outer = std::abs(s.centre);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const bool inside = std::find(group.begin(), group.end(), i) != group.end();
    for (const Complex& z : images(discs[i])) {
      const double distance = std::abs(z - s.centre);
      if (inside && distance <= s.inner)
        ++s.roots;
      else
        s.outer = std::min(s.outer, distance);
    }
  }
  return s;
}

// The radius of a disc about the centre in which the argument principle counts the roots of the group and their images,
// as small as a few trials find; nothing where none does.
std::optional<double> counted(const Impedance& h, const Surroundings& s, double spread) {
  if (!(s.outer > 2 * s.inner)) return std::nullopt;
  const auto holds = [&](double radius) {
    const auto found = h.roots_in_disc(s.centre, radius);
    return found && found->roots == s.roots;
  };
  double radius = std::clamp(std::sqrt(s.inner * s.outer), 1.5 * s.inner, 0.75 * s.outer);
  if (!holds(radius)) return std::nullopt;
  constexpr double smaller = 1.0 / 8;
  const int trials = h.size() <= 64 ? 8 : 2;
  for (int trial = 0; trial < trials && smaller * radius > 2 * spread && holds(smaller * radius); ++trial) radius *= smaller;
  return radius;
}

// Roots that were counted together are in the disc: that is their bound.
void bound_by_disc(const std::vector<Disc>& discs, const std::vector<std::size_t>& group, const Surroundings& s, double radius,
                   Assessment& a) {
  for (const std::size_t i : group) {
    const Disc& d = discs[i];
    const double bound = radius + std::abs(d.centre - s.centre);
    if (d.mode) {
      a.error_bound(d.at) = bound;
      a.cluster[static_cast<std::size_t>(d.at)] = std::max(a.cluster[static_cast<std::size_t>(d.at)], static_cast<Index>(group.size()));
    } else {
      a.unstable.error_bound(d.at) = bound;
    }
  }
}

// A cluster of modes that keeps apart from all others, each with a shape of its own: the bound of its span is as good
// as a disc.
bool independent(const Surroundings& s, const std::vector<Disc>& discs, const std::vector<std::size_t>& group, const Assessment& a) {
  constexpr double small_part = 0.1;
  return std::all_of(group.begin(), group.end(),
                     [&](std::size_t i) { return discs[i].mode && a.error_bound(discs[i].at) <= small_part * s.outer; });
}

// The same of roots off the axis, with left and right shapes of their own; their bound becomes that of their span.
bool independent_off_axis(const Impedance& h, const Spectrum& s, const Surroundings& near, const std::vector<Disc>& discs,
                          const std::vector<std::size_t>& group, Assessment& a) {
  constexpr double small_part = 0.1;
  std::vector<Index> at;
  double nearest_axis = infinity;
  for (const std::size_t i : group) {
    if (discs[i].mode) return false;
    at.push_back(discs[i].at);
    nearest_axis = std::min(nearest_axis, discs[i].centre.real());
  }
  constexpr std::size_t most = 64;
  if (at.size() > most) return false;
  const double bound = span_bound(h, s.unstable, at);
  if (!(bound <= small_part * near.outer) || !(bound <= small_part * nearest_axis)) return false;
  for (const Index i : at) a.unstable.error_bound(i) = std::max(a.unstable.error_bound(i), bound);
  return true;
}

}  // namespace

Exhibits exhibited(const Impedance& h, const Spectrum& s, Assessment& a) {
  const double rounding = solver_residual(s.size());
  Exhibits e;
  e.unstable.assign(static_cast<std::size_t>(s.unstable.count()), true);
  const std::vector<Disc> discs = discs_of(s, a);
  for (const auto& group : touching(discs)) {
    const bool at_rounding = std::all_of(group.begin(), group.end(),
                                         [&](std::size_t i) { return discs[i].mode || a.unstable.own_residual(discs[i].at) <= rounding; });
    if (at_rounding && group.size() == 1 && stands_alone(discs[group[0]])) continue;
    const Surroundings near = around(discs, group);
    if (at_rounding && group.size() > 1 && (independent(near, discs, group, a) || independent_off_axis(h, s, near, discs, group, a)))
      continue;
    double spread = 0;
    for (const std::size_t i : group) spread = std::max(spread, std::abs(discs[i].centre - near.centre));
    if (const auto radius = counted(h, near, spread)) {
      bound_by_disc(discs, group, near, *radius, a);
      continue;
    }
    for (const std::size_t i : group) {
      if (!discs[i].mode) e.unstable[static_cast<std::size_t>(discs[i].at)] = false;
    }
    e.all = false;
    if (e.reason.empty())
      e.reason = fmt::format("{} near λ = {:.6g} + {:.6g}j could not be shown to exist",
                             group.size() == 1 ? "a root" : fmt::format("{} roots", group.size()), near.centre.real(), near.centre.imag());
  }
  return e;
}

}  // namespace gyromode
