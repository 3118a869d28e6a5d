// Branches and encounters of families whose blocks are known by construction: direct sums of small ones with
// closed-form frequencies, disguised by a congruence, in units over 2^±30.
#include "gyromode/models/model.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>

namespace gyromode {
namespace {

using support::Source;

// ω of one irreducible block, the lower first, at a spin; not a number where it is none. Spins are in [0, 1],
// frequencies near 1.
using Block = std::function<std::vector<double>(double spin)>;

struct Truth {
  SpinFamily family;
  std::vector<Block> blocks;
  std::vector<double> gaps;  // of the veerings, in units of frequency

  void append(const SpinFamily& part) {
    const Index old = family.mass.rows(), more = part.mass.rows();
    const auto joined = [&](const Matrix& a, const Matrix& b) {
      Matrix all = Matrix::Zero(old + more, old + more);
      all.topLeftCorner(old, old) = a;
      all.bottomRightCorner(more, more) = b;
      return all;
    };
    family.mass = joined(family.mass, part.mass);
    family.gyroscopic = Matrix::Zero(old + more, old + more);
    family.gyroscopic_per_spin = joined(family.gyroscopic_per_spin, part.gyroscopic_per_spin);
    family.stiffness = joined(family.stiffness, part.stiffness);
    family.stiffness_per_spin2 = joined(family.stiffness_per_spin2, part.stiffness_per_spin2);
  }
};

double uniform(Source& s, double a, double b) { return std::uniform_real_distribution<double>(a, b)(s.bits); }

// Two oscillators a₁ + b₁Ω², a₂ + b₂Ω² of mass 1 that meet at `at`, coupled by c: ω² = mean ± √(half difference² + c²).
void add_stiffening(Source& s, Truth& t, double gap) {
  const double at = uniform(s, 0.3, 0.7), a1 = uniform(s, 0.7, 1.2), a2 = a1 + uniform(s, 0.5, 1.0), b1 = uniform(s, 0, 0.5),
               b2 = b1 - (a2 - a1) / (at * at), c = gap * std::sqrt(a1 + b1 * at * at);
  SpinFamily f;
  f.mass = Matrix::Identity(2, 2);
  f.gyroscopic_per_spin = Matrix::Zero(2, 2);
  f.stiffness = (Matrix(2, 2) << a1, c, c, a2).finished();
  f.stiffness_per_spin2 = (Matrix(2, 2) << b1, 0, 0, b2).finished();
  t.append(f);
  t.blocks.push_back([=](double spin) {
    const double x = a1 + b1 * spin * spin, y = a2 + b2 * spin * spin, d = std::hypot(0.5 * (x - y), c);
    return std::vector<double>{std::sqrt(0.5 * (x + y) - d), std::sqrt(0.5 * (x + y) + d)};  // not a number: divergence
  });
  t.gaps.push_back(gap);
}

// One pair x, y with G = gΩ: forward and backward whirl are blocks of their own.
void add_whirl(Source& s, Truth& t) {
  const double k = uniform(s, 0.6, 2.0), g = uniform(s, 0.2, 1.5);
  SpinFamily f;
  f.mass = Matrix::Identity(2, 2);
  f.gyroscopic_per_spin = (Matrix(2, 2) << 0, g, -g, 0).finished();
  f.stiffness = k * Matrix::Identity(2, 2);
  f.stiffness_per_spin2 = Matrix::Zero(2, 2);
  t.append(f);
  for (const double sign : {-1.0, 1.0}) {
    t.blocks.push_back([=](double spin) {
      const double half = 0.5 * g * spin;
      return std::vector<double>{sign * half + std::sqrt(half * half + k)};
    });
  }
}

// Everything in coordinates that hide the blocks, mass, stiffness and time in other units.
Truth disguised(Source& s, Truth t, double time, double mass) {
  const Index n = t.family.mass.rows();
  Matrix q = Matrix::Identity(n, n);
  for (Index k = 0; k < n; ++k) {  // reflections, and a scale of each coordinate
    Vector v(n);
    for (Index i = 0; i < n; ++i) v(i) = uniform(s, -1, 1);
    q -= (2 / v.squaredNorm()) * (q * v) * v.transpose();
  }
  for (Index i = 0; i < n; ++i) q.row(i) *= std::exp(uniform(s, -1, 1));
  for (Matrix* a : {&t.family.mass, &t.family.gyroscopic_per_spin, &t.family.stiffness, &t.family.stiffness_per_spin2})
    *a = (mass * (q.transpose() * *a * q)).eval();
  t.family.stiffness *= 1 / (time * time);
  for (Matrix* a : {&t.family.mass, &t.family.stiffness, &t.family.stiffness_per_spin2}) *a = (0.5 * (*a + a->transpose())).eval();
  t.family.gyroscopic_per_spin = (0.5 * (t.family.gyroscopic_per_spin - t.family.gyroscopic_per_spin.transpose())).eval();
  return t;
}

// Crossings of branches of two blocks; nothing where they nearly touch.
std::optional<std::vector<double>> crossings(const Block& a, std::size_t i, const Block& b, std::size_t k) {
  constexpr int steps = 2000;
  const auto distance = [&](double spin) {
    const auto x = a(spin), y = b(spin);
    return x[i] - y[k];
  };
  std::vector<double> all;
  double before = 0;
  for (int step = 0; step <= steps; ++step) {
    const double spin = static_cast<double>(step) / steps, now = distance(spin);
    if (step > 0 && before * now < 0) {  // false where either is not a number
      double lo = static_cast<double>(step - 1) / steps, hi = spin;
      for (int h = 0; h < 60; ++h) {
        const double mid = 0.5 * (lo + hi);
        ((distance(mid) < 0) == (before < 0) ? lo : hi) = mid;
      }
      all.push_back(lo);
    } else if (step > 1 && std::abs(now) < 2e-6) {
      return std::nullopt;
    }
    before = now;
  }
  return all;
}

TEST(CampbellFamilies, BranchesDoNotSwapAndEncountersAreToldApart) {
  const char* count = std::getenv("GYROMODE_FAMILIES");
  const int draws = count ? std::atoi(count) : 60;
  Source source{std::mt19937_64(77)};
  int crossed = 0, veered = 0;
  for (int draw = 0; draw < draws; ++draw) {
    Truth plain;
    const double time = std::ldexp(1.0, static_cast<int>(source.integer(-30, 30))),
                 mass = std::ldexp(1.0, static_cast<int>(source.integer(-30, 30)));
    for (Index k = source.integer(1, 2); k > 0; --k) add_stiffening(source, plain, std::pow(10, uniform(source, -9, -1)));
    for (Index k = source.integer(1, 3); k > 0; --k) add_whirl(source, plain);
    const Truth truth = disguised(source, plain, time, mass);
    CampbellOptions o;
    const int spins = static_cast<int>(source.integer(5, 40));
    for (int k = 0; k <= spins; ++k) o.spins.push_back(k / (spins * time));
    const Campbell c = Model(truth.family, 0.0).campbell(o);
    EXPECT_TRUE(c.is_complete()) << draw;

    // Every branch of the truth is one branch of the diagram throughout.
    for (std::size_t b = 0; b < truth.blocks.size(); ++b) {
      for (std::size_t i = 0; i < truth.blocks[b](0).size(); ++i) {
        const bool followed = std::any_of(c.branches.begin(), c.branches.end(), [&](const CampbellBranch& branch) {
          for (std::size_t s = 0; s < c.spins.size(); ++s) {
            const auto w = truth.blocks[b](c.spins[s] * time);
            if (std::isnan(w[i])) {
              if (branch.modes[s]) return false;
            } else if (!branch.modes[s] || !(std::abs(branch.modes[s]->omega * time - w[i]) <= 1e-11)) {
              return false;
            }
          }
          return true;
        });
        EXPECT_TRUE(followed) << draw << ": block " << b << ", branch " << i;
      }
    }
    // Veerings.
    std::vector<double> gaps = plain.gaps, seen;
    for (const Encounter& e : c.encounters) {
      EXPECT_TRUE(e.kind == EncounterKind::crossing || e.kind == EncounterKind::veering) << draw << " " << to_string(e.kind);
      if (e.kind == EncounterKind::veering) seen.push_back(e.gap * time);
    }
    std::sort(gaps.begin(), gaps.end());
    std::sort(seen.begin(), seen.end());
    EXPECT_EQ(seen.size(), gaps.size()) << draw;
    for (std::size_t k = 0; k < std::min(gaps.size(), seen.size()); ++k) {
      EXPECT_NEAR(seen[k], gaps[k], 0.05 * gaps[k] + 1e-13) << draw;
      ++veered;
    }
    // Crossings.
    std::vector<double> expected, found;
    bool clear = true;
    for (std::size_t a = 0; a < truth.blocks.size(); ++a) {
      for (std::size_t b = a + 1; b < truth.blocks.size(); ++b) {
        for (std::size_t i = 0; i < truth.blocks[a](0).size(); ++i) {
          for (std::size_t k = 0; k < truth.blocks[b](0).size(); ++k) {
            const auto at = crossings(truth.blocks[a], i, truth.blocks[b], k);
            if (!at) clear = false;
            if (at) expected.insert(expected.end(), at->begin(), at->end());
          }
        }
      }
    }
    for (const Encounter& e : c.encounters) {
      if (e.kind == EncounterKind::crossing) found.push_back(e.spin * time);
    }
    if (!clear) continue;
    std::sort(expected.begin(), expected.end());
    std::sort(found.begin(), found.end());
    ASSERT_EQ(found.size(), expected.size()) << draw;
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-9) << draw;
    crossed += static_cast<int>(found.size());
  }
  std::printf("%d crossings, %d veerings in %d families\n", crossed, veered, draws);
}

}  // namespace
}  // namespace gyromode
