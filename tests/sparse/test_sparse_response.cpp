// Responses of sparse systems, by those of the dense engine.
#include "gyromode/base/error.h"
#include "gyromode/modes/modes.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/reduced_sweep.h"
#include "gyromode/motion/windowed_motion.h"
#include "sparse/as_dense.h"
#include "support/random_matrices.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gyromode {
namespace {

// A chain held at one end, its coordinates in phase and in quadrature by turns or not.
struct Held {
  Matrix m, g, k;
};

Held held(support::Source& source, Index n, bool partition) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  Held c{Matrix::Zero(n, n), Matrix::Zero(n, n), Matrix::Zero(n, n)};
  const Index step = partition ? 2 : 1;
  for (Index i = 0; i < n; ++i) {
    c.m(i, i) = uniform(1, 2);
    c.k(i, i) += 0.3;
    if (i + step < n) {
      const double s = uniform(1, 3);
      c.k(i, i) += s;
      c.k(i + step, i + step) += s;
      c.k(i, i + step) = c.k(i + step, i) = -s;
    }
    if (i + 1 < n) {
      c.g(i, i + 1) = uniform(-1, 1);
      c.g(i + 1, i) = -c.g(i, i + 1);
    }
  }
  return c;
}

SparseSystem sparse_of(const Held& c) {
  return SparseSystem({support::lower_of(c.m), support::lower_of(c.g, false), support::lower_of(c.k), {}, {}});
}

Vector any(support::Source& source, Index n) {
  Vector v(n);
  for (double& x : v) x = std::uniform_real_distribution<double>(-1, 1)(source.bits);
  return v;
}

// In units of length and time of their own.
Held in_units(Held c, double stiffness, double time) {
  c.m *= stiffness * time * time;
  c.g *= stiffness * time;
  c.k *= stiffness;
  return c;
}

TEST(SparseResponse, OverFrequenciesIsThatOfTheDenseEngine) {
  support::Source source{std::mt19937_64(20261127)};
  for (const int unit : {-30, 0, 30}) {
    for (const bool partition : {true, false}) {
      const Held c = in_units(held(source, 60, partition), std::exp2(unit), std::exp2(-unit / 3));
      const double rate = std::exp2(unit / 3);
      const Vector force = any(source, 60), grid = Vector::LinSpaced(15, 0, 2.5 * rate);
      const FrequencyResponse dense = frequency_response(System(c.m, c.g, c.k), force, grid);
      const std::vector<Index> chosen{3, 17, 59};
      const FrequencyResponse r = frequency_response(sparse_of(c), force, grid, chosen);
      ASSERT_EQ(r.points.size(), dense.points.size());
      ASSERT_EQ(r.modes.size(), dense.modes.size());
      EXPECT_EQ(r.coverage->status, CoverageStatus::complete);
      for (std::size_t i = 0; i < r.modes.size(); ++i) {
        EXPECT_NEAR(r.modes[i].omega, dense.modes[i].omega, 1e-10 * dense.modes[i].omega);
        EXPECT_NEAR(r.modes[i].participation, dense.modes[i].participation, 1e-7);
        EXPECT_EQ(r.modes[i].driven, dense.modes[i].driven);
      }
      for (std::size_t p = 0; p < r.points.size(); ++p) {
        EXPECT_EQ(r.points[p].added, dense.points[p].added);
        const ComplexVector q = dense.points[p].q(chosen);
        constexpr double beside_a_mode = 1e-7;  // 10⁻⁵ of ω beside it the response takes the error of ω 10⁵ times
        EXPECT_LT((r.points[p].q - q).norm(), (r.points[p].added ? beside_a_mode : 1e-9) * dense.points[p].q.norm()) << unit << " " << p;
      }
    }
  }
}

// Few factorisations serve a sweep, of any spin; what comes of them is what a factorisation at every point gives.
TEST(SparseResponse, ASweepIsProjectedOnModesAndCorrected) {
  support::Source source{std::mt19937_64(20261128)};
  for (const double spin : {0.01, 1.0, 30.0}) {
    for (const bool partition : {true, false}) {
      Held c = held(source, 500, partition);
      c.g *= spin;
      const SparseSystem s = sparse_of(c);
      ModesOptions o;
      o.lowest = 20;
      o.shapes = true;
      const ModesResult modes = find_modes(s, o);
      ASSERT_TRUE(modes.is_complete());
      ComplexMatrix shapes(500, static_cast<Index>(modes.modes.size()));
      for (Index k = 0; k < shapes.cols(); ++k) shapes.col(k) = modes.modes[static_cast<std::size_t>(k)].shape;
      const SteadySolver solver(s);
      const ComplexVector f = any(source, 500).cast<Complex>();
      ReducedSweep sweep(solver, f, shapes);
      const double last = 0.9 * modes.modes.back().omega;
      constexpr Index points = 100;
      for (const double omega : Vector::LinSpaced(points, 0.001 * last, last)) {
        const ComplexVector q = sweep.at(omega), direct = solver.at(omega, f);
        EXPECT_LT((q - direct).norm(), 1e-8 * direct.norm()) << spin << " " << partition << " " << omega;
      }
      EXPECT_LE(sweep.factored(), 10) << spin << " " << partition;
    }
  }
}

TEST(SparseResponse, OnAModeIsInfiniteOrTheLimit) {
  // Two pairs of coordinates that have nothing in common: the force drives the modes of one.
  Held c{Matrix::Identity(4, 4), Matrix::Zero(4, 4), Matrix::Zero(4, 4)};
  c.g(0, 1) = 1;
  c.g(1, 0) = -1;
  c.k.diagonal() << 4, 4, 9, 16;
  Vector force = Vector::Zero(4), grid(3);
  force(2) = 1;
  grid << 3, 4, 5;
  const FrequencyResponse r = frequency_response(sparse_of(c), force, grid, {}, false);
  ASSERT_EQ(r.points.size(), 3u);
  EXPECT_TRUE(r.points[0].resonance());
  EXPECT_EQ(r.points[1].driven, Driven::no);
  EXPECT_NEAR(r.points[1].q(2).real(), 1 / (9.0 - 16.0), 1e-10);
  EXPECT_NEAR(r.points[2].q(2).real(), 1 / (9.0 - 25.0), 1e-15);
}

// In all modes it is the motion itself, whatever drives it.
TEST(SparseResponse, OverTimeInAllModesIsThatOfTheDenseEngine) {
  support::Source source{std::mt19937_64(20261128)};
  for (const int unit : {-30, 0, 30}) {
    for (const bool partition : {true, false}) {
      const double rate = std::exp2(unit / 3);
      const Held c = in_units(held(source, 24, partition), std::exp2(unit), 1 / rate);
      const State start{any(source, 24), rate * any(source, 24)};
      const double on_a_mode = find_modes(System(c.m, c.g, c.k)).modes[5].omega;
      for (const double nu : {0.0, 0.4 * rate, on_a_mode}) {
        std::vector<Force> forces{{Force::Course::harmonic, std::exp2(unit) * any(source, 24), nu},
                                  {Force::Course::impulse, std::exp2(unit) / rate * any(source, 24), 0}};
        const Response dense(System(c.m, c.g, c.k), start, forces);
        ModesOptions all;
        all.window.b = 20 * rate;
        const WindowedMotion m(sparse_of(c), start, forces, all, {});
        EXPECT_NEAR(m.initial_energy(), dense.initial_energy(), 1e-12 * dense.initial_energy());
        EXPECT_LT(std::abs(m.energy_left_out()), 1e-18 * dense.initial_energy());
        EXPECT_LT(m.departure(), 1e-9);
        for (const double t : {0.0, 0.7, 13.0}) {
          const State a = m.at(t / rate), b = dense.at(t / rate);
          EXPECT_LT((a.q - b.q).norm(), 1e-8 * b.q.norm()) << unit << " " << nu << " " << t;
          EXPECT_LT((a.qdot - b.qdot).norm(), 1e-8 * b.qdot.norm()) << unit << " " << nu << " " << t;
        }
      }
    }
  }
}

// Slow modes of both energy signs beside fast ones: a projection has to be repeated on what it leaves.
TEST(SparseResponse, OverTimeOfWhatSpinStabilisesIsThatOfTheDenseEngine) {
  support::Source source{std::mt19937_64(20261130)};
  for (const double spin : {8.0, 1024.0, 32768.0}) {
    Held c{Matrix::Identity(5, 5), Matrix::Zero(5, 5), Matrix::Zero(5, 5)};
    c.k.diagonal() << -6, -5, 2, 3, 4;
    c.k(2, 4) = c.k(4, 2) = -1;
    for (const Index i : {0, 2}) {
      c.g(i, i + 1) = spin;
      c.g(i + 1, i) = -spin;
    }
    const State start{any(source, 5), any(source, 5)};
    for (const State& from : {start, State::rest(5)}) {
      const std::vector<Force> forces{{Force::Course::harmonic, any(source, 5), 0.7}, {Force::Course::step, any(source, 5), 0}};
      const Response dense(System(c.m, c.g, c.k), from, forces);
      ModesOptions all;
      all.window.b = 1e8;
      const WindowedMotion m(sparse_of(c), from, forces, all, {});
      ASSERT_EQ(m.modes().coverage.status, CoverageStatus::complete) << spin;
      EXPECT_EQ(m.modes().stability, Stability::gyroscopically_stabilised) << spin;
      EXPECT_LT(m.departure(), 1e-12) << spin;
      const State a = m.at(5), b = dense.at(5);
      EXPECT_LT((a.q - b.q).norm(), (1e-9 + m.phase_error(5) + dense.phase_error(5)) * b.q.norm()) << spin;
    }
  }
}

// In some of them what is slow is right but for what they leave out, and that is stated.
TEST(SparseResponse, OverTimeInSomeModesStatesWhatIsLeftOut) {
  support::Source source{std::mt19937_64(20261129)};
  const Held c = held(source, 80, true);
  const SparseSystem s = sparse_of(c);
  ModesOptions lowest;
  lowest.lowest = 12;
  const ModesResult modes = find_modes(System(c.m, c.g, c.k), {});
  const double nu = 0.5 * modes.modes[0].omega;
  const std::vector<Force> forces{{Force::Course::harmonic, any(source, 80), nu}};
  const WindowedMotion m(s, State::rest(80), forces, lowest, {});
  EXPECT_EQ(m.modal().size(), 12u);
  // The steady part is exact: of the force alone, after the modes' own share of it.
  Vector grid(1);
  grid << nu;
  const ComplexVector steady = frequency_response(s, forces[0].amplitude, grid, {}, false).points[0].q;
  const Response dense(System(c.m, c.g, c.k), State::rest(80), forces);
  const double own = 2 * steady.norm();
  for (const double t : {3.0, 8.0}) EXPECT_LT((m.at(t).q - dense.at(t).q).norm(), 0.1 * own);
  // Of an initial state the energies of the modes and what is left out are all of it.
  const State start{any(source, 80), any(source, 80)};
  const WindowedMotion free(s, start, {}, lowest, {0, 1});
  double in_modes = 0;
  for (const ModalShare& share : free.modal()) in_modes += share.energy;
  EXPECT_NEAR(in_modes + free.energy_left_out(), free.initial_energy(), 1e-10 * free.initial_energy());
  EXPECT_GT(free.energy_left_out(), 0.1 * free.initial_energy());
  EXPECT_EQ(free.at(1).q.size(), 2);
}

TEST(SparseResponse, OfAnUnstableSystemIsRefused) {
  Held c{Matrix::Identity(4, 4), Matrix::Zero(4, 4), Matrix::Zero(4, 4)};
  c.k.diagonal() << -1, 2, 3, 4;
  ModesOptions o;
  o.lowest = 2;
  EXPECT_THROW(WindowedMotion(sparse_of(c), State::rest(4), {}, o, {}), NotApplicable);
}

}  // namespace
}  // namespace gyromode
