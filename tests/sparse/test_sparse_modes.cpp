// Modes of sparse systems: exactly known spectra, the dense engine, and what is refused.
#include "gyromode/base/error.h"
#include "gyromode/models/mesh_symmetry.h"
#include "gyromode/models/structure_mesh.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/matrix.h"
#include "meshes/bricks.h"
#include "sparse/as_dense.h"
#include "support/random_matrices.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>

namespace gyromode {
namespace {

// A chain of `masses` unit masses on unit springs between walls, vibrating across two axes, seen from axes that turn at
// Ω: frequencies |ω_k ± Ω|, ω_k = 2 sin(kπ / (2(N + 1))), each exactly. What is isotropic about its axis is solved in
// axes that stand still; with one more coordinate along the axis, far above all others, it is not.
StructureParts chain(Index masses, double spin, bool isotropic = true) {
  std::vector<Eigen::Triplet<double>> m, k;
  StructureParts p;
  p.spin = spin;
  for (Index i = 0; i < masses; ++i) {
    for (int d = 0; d < 2; ++d) {
      const int at = static_cast<int>(2 * i) + d;
      p.coordinates.push_back({i + 1, d});
      m.emplace_back(at, at, 1);
      k.emplace_back(at, at, 2 - spin * spin);
      if (i > 0) k.emplace_back(at, at - 2, -1);
    }
  }
  const Index n = 2 * masses + (isotropic ? 0 : 1);
  if (!isotropic) {
    p.coordinates.push_back({masses, 2});
    m.emplace_back(static_cast<int>(n) - 1, static_cast<int>(n) - 1, 1);
    k.emplace_back(static_cast<int>(n) - 1, static_cast<int>(n) - 1, 100);
  }
  p.mass.resize(n, n);
  p.stiffness.resize(n, n);
  p.mass.setFromTriplets(m.begin(), m.end());
  p.stiffness.setFromTriplets(k.begin(), k.end());
  return p;
}

std::vector<double> known(Index masses, double spin) {
  std::vector<double> all;
  for (Index k = 1; k <= masses; ++k) {
    const double w = 2 * std::sin(static_cast<double>(k) * std::numbers::pi / (2 * (static_cast<double>(masses) + 1)));
    all.push_back(std::abs(w - spin));
    all.push_back(w + spin);
  }
  std::sort(all.begin(), all.end());
  return all;
}

void expect_window(Index masses, double spin, double a, double b, bool isotropic) {
  const SparseSystem system(assembled(chain(masses, spin, isotropic)));
  ModesOptions o;
  o.window = {a, b};
  const ModesResult r = find_modes(system, o);
  std::vector<double> expected;
  for (const double w : known(masses, spin)) {
    if (w >= a && w < b) expected.push_back(w);
  }
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete) << spin << " [" << a << ", " << b << "): " << r.coverage.reason;
  ASSERT_EQ(r.modes.size(), expected.size()) << spin << " [" << a << ", " << b << ")";
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(r.modes[k].omega, expected[k], 1e-10 * (1 + expected[k])) << spin << " " << k;
    EXPECT_NEAR(r.modes[k].omega, expected[k], 2 * r.modes[k].error_bound + 1e-15) << "the bound holds";
  }
}

void expect_window(Index masses, double spin, double a, double b) {
  for (const bool isotropic : {true, false}) expect_window(masses, spin, a, b, isotropic);
}

TEST(SparseModes, WindowsOfAChainInTurningAxes) {
  for (const double spin : {0.0, 0.0003, 0.004, 0.3}) {
    const Index masses = spin > 0.1 ? 60 : 1000;
    const double low = known(masses, spin).front();
    expect_window(masses, spin, 0, low + 0.02);
    expect_window(masses, spin, 0.5, 0.52);
    expect_window(masses, spin, 1.9, 1.91);
  }
}

// Below some ω_k the axes turn faster than a mode vibrates: K is indefinite, by two eigenvalues a mode, and the mode
// has negative energy.
TEST(SparseModes, FastAxesMakeNegativeEnergy) {
  const Index masses = 400;
  const double spin = 0.02;  // above ω₁ = 0.00783 and ω₂ = 0.01567
  for (const bool isotropic : {true, false}) {
    const SparseSystem system(assembled(chain(masses, spin, isotropic)));
    ModesOptions o;
    o.window.b = 0.03;
    const ModesResult r = find_modes(system, o);
    EXPECT_EQ(r.stability, Stability::gyroscopically_stabilised);
    EXPECT_EQ(r.index_balance.negative, 4);
    EXPECT_EQ(r.index_balance.negative_energy, 2);
    EXPECT_EQ(r.negative_modes.size(), 2U);
    EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
    EXPECT_EQ(std::count_if(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.energy_sign < 0; }), 2);
    EXPECT_EQ(r.solver.find("isotropic") != std::string::npos, isotropic) << r.solver;
    const CountResult c = count_modes(system, o.window);
    EXPECT_EQ(c.count, static_cast<Index>(r.modes.size()));
    EXPECT_EQ(c.status, CountStatus::exact);
  }
}

// The axes turn faster than most modes, or than all of them, vibrate: K has hundreds of negative directions. Windows
// anywhere, the lowest, and the motions by the matrices that were given.
TEST(SparseModes, AxesFasterThanAllThatTurnsWithThem) {
  const Index masses = 300;
  for (const double spin : {0.5, 1.3, 1.9999, 2.5, 40.0}) {
    const std::vector<double> all = known(masses, spin);
    const std::size_t n = all.size();
    for (const std::size_t first : {std::size_t{2}, n / 3, n - 50})
      expect_window(masses, spin, 0.5 * (all[first - 1] + all[first]), 0.5 * (all[first + 40] + all[first + 41]), true);
    expect_window(masses, spin, 0, 0.5 * (all[30] + all[31]), true);
    ModesOptions o;
    o.lowest = 20;
    const ModesResult r = find_modes(SparseSystem(assembled(chain(masses, spin))), o);
    EXPECT_TRUE(r.is_complete()) << spin << ": " << r.coverage.reason;
    ASSERT_GE(r.modes.size(), 20U);
    for (std::size_t k = 0; k < r.modes.size(); ++k) {
      EXPECT_NEAR(r.modes[k].omega, all[k], 1e-10 * (1 + spin)) << spin << " " << k;
      EXPECT_LE(r.modes[k].residual, 3e-11) << spin << " " << k;
    }
  }
}

// The same as the dense engine has it, in other units and with signs and places of coordinates mixed.
TEST(SparseModes, IsotropyIsFoundInAnyOrder) {
  support::Source source{std::mt19937_64(5)};
  for (int draw = 0; draw < 12; ++draw) {
    const Index half = source.integer(3, 12), n = 2 * half;
    const double unit = std::exp2(static_cast<double>(source.integer(-30, 30))),
                 time = std::exp2(static_cast<double>(source.integer(-20, 20)));
    const double spin = std::uniform_real_distribution<double>(0.1, 3)(source.bits) / time;
    const Matrix m0 = unit * source.symmetric(half, 0), k0 = unit / (time * time) * source.symmetric(half, 0);
    std::vector<Index> place(static_cast<std::size_t>(n));
    for (std::size_t i = 0; i < place.size(); ++i) place[i] = static_cast<Index>(i);
    std::shuffle(place.begin(), place.end(), source.bits);
    Matrix m = Matrix::Zero(n, n), g = m, k = m;
    for (Index i = 0; i < half; ++i) {
      for (Index j = 0; j < half; ++j) {
        for (int d = 0; d < 2; ++d) {
          const Index r = place[static_cast<std::size_t>(2 * i + d)], c = place[static_cast<std::size_t>(2 * j + d)],
                      across = place[static_cast<std::size_t>(2 * j + 1 - d)];
          m(r, c) = m0(i, j);
          k(r, c) = k0(i, j) - spin * spin * m0(i, j);
          g(r, across) = (d == 0 ? -2 : 2) * spin * m0(i, j);
        }
      }
    }
    const SparseSystem system({support::lower_of(m), support::lower_of(g, false), support::lower_of(k), {}, {}});
    ModesOptions o;
    o.lowest = std::min<Index>(n - 2, 8);
    const ModesResult r = find_modes(system, o), dense = find_modes(System(m, g, k));
    EXPECT_NE(r.solver.find("isotropic"), std::string::npos) << draw;
    EXPECT_TRUE(r.is_complete()) << draw << ": " << r.coverage.reason;
    EXPECT_EQ(r.stability, dense.stability) << draw;
    EXPECT_EQ(r.index_balance.negative, dense.index_balance.negative) << draw;
    EXPECT_EQ(r.index_balance.negative_energy, dense.index_balance.negative_energy) << draw;
    EXPECT_EQ(r.negative_modes.size(), dense.negative_modes.size()) << draw;
    for (std::size_t i = 0; i < r.modes.size(); ++i) {
      EXPECT_NEAR(r.modes[i].omega, dense.modes[i].omega, 1e-10 * dense.modes[i].omega + 2 * dense.modes[i].error_bound)
          << draw << " " << i;
      EXPECT_EQ(r.modes[i].energy_sign, dense.modes[i].energy_sign) << draw << " " << i;
      EXPECT_LE(r.modes[i].residual, 1e-12) << draw << " " << i;
    }
    // One entry that differs beyond rounding is enough for another way, with the same roots.
    Matrix other = k;
    other(place[0], place[0]) *= 1 + 1e-9;
    const ModesResult s =
        find_modes(SparseSystem({support::lower_of(m), support::lower_of(g, false), support::lower_of(other), {}, {}}), o);
    EXPECT_EQ(s.solver.find("isotropic"), std::string::npos) << draw;
  }
}

TEST(SparseModes, LowestOfAChain) {
  for (const double spin : {0.0, 0.001}) {
    ModesOptions o;
    o.lowest = 12;
    const ModesResult r = find_modes(SparseSystem(assembled(chain(3000, spin, false))), o);
    EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
    const std::vector<double> expected = known(3000, spin);
    ASSERT_GE(r.modes.size(), 12u);
    for (std::size_t k = 0; k < r.modes.size(); ++k) EXPECT_NEAR(r.modes[k].omega, expected[k], 1e-10) << spin << " " << k;
  }
}

// Banded systems of both classes, K definite or not, by the dense engine.
TEST(SparseModes, AreThoseOfTheDenseEngine) {
  support::Source source{std::mt19937_64(8)};
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  int compared = 0;
  const char* asked = std::getenv("GYROMODE_SPARSE");
  const int draws = asked ? std::atoi(asked) : 40;
  for (int draw = 0; draw < draws; ++draw) {
    const Index n = source.integer(20, draw % 5 == 4 ? 300 : 90), band = 4;
    const bool partition = draw % 2 == 0;
    const double unit = std::exp2(static_cast<double>(source.integer(-30, 30))),
                 time = std::exp2(static_cast<double>(source.integer(-20, 20)));
    Matrix m = Matrix::Zero(n, n), g = m, k = m;
    for (Index j = 0; j < n; ++j) {
      m(j, j) = uniform(1, 2);
      k(j, j) = uniform(draw % 3 == 0 ? 1 : 5, 12);
      for (Index i = j + 1; i < std::min(n, j + band); ++i) {
        const bool cross = (i % 2) != (j % 2);
        if (!partition || !cross) m(i, j) = m(j, i) = uniform(-0.1, 0.1);
        if (!partition || !cross) k(i, j) = k(j, i) = uniform(-1.5, 1.5);
        if (!partition || cross) {
          g(i, j) = uniform(-1, 1);
          g(j, i) = -g(i, j);
        }
      }
    }
    m *= unit;
    g *= unit / time;
    k *= unit / (time * time);
    if (support::expect_as_dense(m, g, k, fmt::format("draw {}", draw))) ++compared;
  }
  EXPECT_GT(compared, draws / 2);
}

// Both blocks of K have negative directions: Lanczos beside the motions that make them, of any spin.
TEST(SparseModes, BeyondTheFirstCriticalSpeeds) {
  const bench::BrickMesh mesh = bench::box({0.1, 0.104, 1.0}, {2, 2, 10}, true);
  for (const double spin : {640.0, 660.0, 1500.0, 3900.0, 6400.0}) {
    const SparseMatrices m = assembled(assembled_bricks(mesh, {}, spin));
    const ModesResult dense = find_modes(System(sparse::full(m.mass, 1), sparse::full(m.gyroscopic, -1), sparse::full(m.stiffness, 1)));
    for (const bool partition : {true, false}) {
      StructureParts parts = assembled_bricks(mesh, {}, spin);
      for (const MeshCoordinate& c : parts.coordinates) parts.positions.push_back(mesh.nodes[static_cast<std::size_t>(c.node - 1)]);
      const SparseSystem s(partition ? in_symmetric_coordinates(parts) : assembled(parts));
      ModesOptions o;
      o.lowest = 12;
      const ModesResult r = find_modes(s, o);
      EXPECT_TRUE(r.is_complete()) << spin << " " << partition << ": " << r.coverage.reason;
      EXPECT_EQ(r.stability, dense.stability) << spin;
      ASSERT_GE(r.modes.size(), 12U);
      for (std::size_t k = 0; k < r.modes.size(); ++k) {
        EXPECT_NEAR(r.modes[k].omega, dense.modes[k].omega, 1e-9 * dense.modes[k].omega) << spin << " " << partition;
        EXPECT_EQ(r.modes[k].energy_sign, dense.modes[k].energy_sign) << spin << " " << partition << " " << k;
        EXPECT_LE(r.modes[k].residual, 1e-10) << spin << " " << partition << " " << k;
      }
      ASSERT_EQ(r.unstable.size(), dense.unstable.size()) << spin << " " << partition;
      for (std::size_t k = 0; k < r.unstable.size(); ++k)
        EXPECT_NEAR(r.unstable[k].growth_rate, dense.unstable[k].growth_rate, 1e-8 * dense.unstable[k].growth_rate);
      EXPECT_EQ(s.basis() != nullptr, partition);
      if (r.index_balance.negative > 1 && (partition || r.unstable.empty())) {
        EXPECT_NE(r.solver.find("beside"), std::string::npos) << spin << " " << partition << ": " << r.solver;
      }
    }
  }
}

// Copies of one chain: every frequency as many times as there are copies, more than a block has columns.
TEST(SparseModes, ManyEqualRoots) {
  const Index masses = 40, copies = 25;
  const double spin = 0.02;
  StructureParts one = chain(masses, spin), many = one;
  many.coordinates.clear();
  std::vector<Eigen::Triplet<double>> m, k;
  const Index n = 2 * masses;
  for (Index c = 0; c < copies; ++c) {
    for (const MeshCoordinate& x : one.coordinates) many.coordinates.push_back({x.node + c * masses, x.direction});
    for (const auto& [a, to] : {std::pair(&one.mass, &m), {&one.stiffness, &k}}) {
      for (Index j = 0; j < n; ++j) {
        for (SparseMatrix::InnerIterator it(*a, j); it; ++it)
          to->emplace_back(static_cast<int>(it.row() + c * n), static_cast<int>(j + c * n), it.value());
      }
    }
  }
  const Index last = copies * n;  // along the axis, far above all others: what makes it not isotropic
  many.coordinates.push_back({copies * masses, 2});
  m.emplace_back(static_cast<int>(last), static_cast<int>(last), 1);
  k.emplace_back(static_cast<int>(last), static_cast<int>(last), 100);
  many.mass.resize(last + 1, last + 1);
  many.stiffness.resize(last + 1, last + 1);
  many.mass.setFromTriplets(m.begin(), m.end());
  many.stiffness.setFromTriplets(k.begin(), k.end());
  StructureParts isotropic = many;
  isotropic.coordinates.pop_back();
  isotropic.mass = SparseMatrix(many.mass.topLeftCorner(last, last));
  isotropic.stiffness = SparseMatrix(many.stiffness.topLeftCorner(last, last));
  const std::vector<double> once = known(masses, spin);
  const auto expect = [&](const ModesResult& r, std::size_t from, std::size_t to) {
    EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
    ASSERT_EQ(r.modes.size(), (to - from) * static_cast<std::size_t>(copies));
    for (std::size_t i = 0; i < r.modes.size(); ++i)
      EXPECT_NEAR(r.modes[i].omega, once[from + i / static_cast<std::size_t>(copies)], 1e-10);
  };
  for (const StructureParts& parts : {many, isotropic}) {
    const SparseSystem system(assembled(parts));
    ModesOptions o;
    o.window = {0.5 * (once[1] + once[2]), 0.5 * (once[4] + once[5])};
    expect(find_modes(system, o), 2, 5);
    o = {};
    o.lowest = 30;
    expect(find_modes(system, o), 0, 2);
  }
}

// More modes than one shift is asked for, and windows that reach below the lowest mode or above the highest.
TEST(SparseModes, WindowsOfSeveralShifts) {
  expect_window(400, 0.004, 0.3, 0.9);
  expect_window(100, 0.0003, 1e-9, 0.5);
  expect_window(100, 0.0003, 0.5, 3);
  expect_window(30, 0.0003, 1e-9, 3);
}

// Modes at rest are near enough to the ends for counts of them to leave it open, or not: γ from a tenth of the distance
// of modes to ten times that. Ends anywhere between modes, near one too.
TEST(SparseModes, InteriorWindowsWhateverTheCountsAtRestSay) {
  support::Source source{std::mt19937_64(11)};
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  for (int draw = 0; draw < 30; ++draw) {
    const Index masses = 200;
    const double rest = known(masses, 0)[0], spin = rest * std::exp2(uniform(-6, -0.1));
    const std::vector<double> all = known(masses, spin);
    const auto first = static_cast<std::size_t>(source.integer(2, 250)), last = first + static_cast<std::size_t>(source.integer(0, 40));
    const double near = draw % 3 == 0 ? 1e-7 : 0.5;
    expect_window(masses, spin, all[first] - near * uniform(0, 1) * (all[first] - all[first - 1]),
                  all[last] + near * uniform(0.01, 1) * (all[last + 1] - all[last]));
  }
}

// Work that is stopped leaves what was found around the shift, and says so.
TEST(SparseModes, StoppedInsideAWindow) {
  const SparseSystem system(assembled(chain(600, 0.0003, false)));
  const std::vector<double> all = known(600, 0.0003);
  bool some = false;
  for (int after = 1; after < 30; ++after) {
    ModesOptions o;
    o.window = {0.5, 0.6};
    int told = 0;
    o.progress.tell = [&](std::string_view, Index, Index) { ++told; };
    o.progress.stop = [&] { return told >= after; };
    try {
      const ModesResult r = find_modes(system, o);
      if (!r.coverage.interrupted) continue;
      some = true;
      EXPECT_EQ(r.coverage.status, CoverageStatus::incomplete);
      EXPECT_GE(r.coverage.window.a, 0.5);
      EXPECT_LE(r.coverage.window.b, 0.6);
      const auto expected = std::count_if(all.begin(), all.end(), [&](double w) { return r.coverage.window.contains(w); });
      EXPECT_EQ(static_cast<Index>(r.modes.size()), expected)
          << after << " [" << r.coverage.window.a << ", " << r.coverage.window.b << "): " << r.coverage.reason;
    } catch (const Interrupted&) {
    }
  }
  EXPECT_TRUE(some);
}

// Ends on a mode, and 10⁻⁸ from one.
TEST(SparseModes, EndsOnModes) {
  const SparseSystem system(assembled(chain(1000, 0.0003)));
  const std::vector<double> all = known(1000, 0.0003);
  for (const double off : {0.0, 1e-8, -1e-8}) {
    ModesOptions o;
    o.window = {all[100] * (1 - off), all[120] * (1 + off)};
    const ModesResult r = find_modes(system, o);
    EXPECT_TRUE(r.is_complete()) << off << ": " << r.coverage.reason;
    const auto expected = std::count_if(all.begin(), all.end(), [&](double w) { return r.coverage.window.contains(w); });
    EXPECT_EQ(static_cast<Index>(r.modes.size()), expected) << off;
    EXPECT_EQ(expected, off < 0 ? 19 : 21);
  }
}

TEST(SparseModes, WhatIsRefused) {
  StructureParts p = chain(3, 0.1);
  StructureParts coupled = p;
  coupled.mass.coeffRef(1, 0) = 0.2;
  EXPECT_THROW(assembled(coupled), LawBroken);
  StructureParts uneven = p;
  uneven.mass.coeffRef(1, 1) = 2;
  EXPECT_THROW(assembled(uneven), LawBroken);
  StructureParts apart = p;
  apart.coordinates = {{1, 0}, {2, 1}, {3, 0}, {3, 1}, {4, 0}, {4, 1}};
  EXPECT_THROW(assembled(apart), LawBroken);
  StructureParts no_axis = p;
  no_axis.axis = {0, 0, 0};
  EXPECT_THROW(assembled(no_axis), LawBroken);
  SparseMatrices negative = assembled(p);
  negative.mass.coeffRef(0, 0) = -1;
  EXPECT_THROW(SparseSystem{negative}, LawBroken);
  EXPECT_THROW(find_modes(SparseSystem(assembled(p))), InvalidArgument) << "no end, no number";
}

}  // namespace
}  // namespace gyromode
