#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/motion/response.h"
#include "reference/matrix_exponential.h"
#include "support/random_matrices.h"
#include "support/random_system.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

using namespace gyromode;
using reference::exact_state;
using support::Source;

namespace {

State random_state(Source& s, Index n) { return {s.gaussian(n, 1), s.gaussian(n, 1)}; }

double distance(const State& a, const State& b, double omega) { return std::hypot(omega * (a.q - b.q).norm(), (a.qdot - b.qdot).norm()); }
double size(const State& a, double omega) { return std::hypot(omega * a.q.norm(), a.qdot.norm()); }

// M = 1 + small, K > 0 or indefinite and stabilised by a strong G.
System stable_system(Source& s, Index n, bool indefinite) {
  const Matrix m = s.symmetric(n, 0);
  const Matrix k = s.symmetric(n, 0) * (indefinite ? -1 : 1);
  if (!indefinite) return System(m, s.skew(n), k);
  Matrix g = Matrix::Zero(n, n);  // pairs, K < 0: stable above a threshold
  for (Index i = 0; i + 1 < n; i += 2) g(i, i + 1) = 9 + static_cast<double>(i), g(i + 1, i) = -g(i, i + 1);
  const Matrix q = s.orthogonal(n);
  return System(Matrix::Identity(n, n), skew_part(q.transpose() * g * q), symmetric_part(q.transpose() * k * q));
}

}  // namespace

// ≤ 20 n ε ω_max t, with the rounding of a state to begin with.
TEST(Response, AgainstTheMatrixExponentialTo50Digits) {
  Source s{std::mt19937_64(1)};
  double worst = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const Index n = 2 * s.integer(1, 6);
    const System system = stable_system(s, n, trial % 3 == 2);
    const State start = random_state(s, n);
    const Response r(system, start);
    ASSERT_NE(r.stability(), Stability::unstable) << trial;
    EXPECT_EQ(r.remainder_size(), 0) << trial;
    const double fastest = r.modal().back().omega, period = 2 * std::numbers::pi / fastest;
    for (const double periods : {0.1, 1.0, 10.0, 100.0, 1000.0}) {
      const double t = periods * period;
      const State exact = exact_state(system, start, t);
      const double bar = 20 * static_cast<double>(n) * epsilon * std::max(1.0, fastest * t);
      const double error = distance(r.at(t), exact, fastest) / size(exact, fastest);
      EXPECT_LE(error, bar) << "trial " << trial << ", n " << n << ", " << periods << " periods";
      worst = std::max(worst, error / bar);
    }
  }
  RecordProperty("worst", std::to_string(worst));
}

TEST(Response, EnergyIsConstantAndIsTheSumOfTheShares) {
  Source s{std::mt19937_64(2)};
  for (int trial = 0; trial < 20; ++trial) {
    const Index n = 2 * s.integer(1, 10);
    const System system = stable_system(s, n, trial % 2 == 1);
    const Response r(system, random_state(s, n));
    double sum = r.zero_energy() + r.remainder_energy(), scale = 0;
    for (const ModalShare& m : r.modal()) {
      sum += m.energy;
      scale += std::abs(m.energy);
      EXPECT_EQ(m.energy >= 0 ? 1 : -1, m.energy_sign);
    }
    EXPECT_NEAR(sum, r.initial_energy(), 1e-12 * scale);
    const double fastest = r.modal().back().omega;
    for (int k = 0; k <= 50; ++k)
      EXPECT_NEAR(r.energy(r.at(2 * std::numbers::pi / fastest * 20 * k)), r.initial_energy(), 1e-12 * scale) << trial;
  }
}

TEST(Response, OneModeAlone) {
  Source s{std::mt19937_64(3)};
  const System system = stable_system(s, 6, false);
  const Response any(system, random_state(s, 6));
  const ModalShare& m = any.modal()[2];
  const Response r(system, {(m.shape * std::polar(0.3, 0.7)).real(), (m.shape * std::polar(0.3, 0.7) * Complex(0, m.omega)).real()});
  for (const ModalShare& other : r.modal()) {
    if (other.omega == m.omega) {
      EXPECT_NEAR(other.amplitude, 0.3, 1e-14);
      EXPECT_NEAR(other.phase, 0.7, 1e-13);
    } else {
      EXPECT_LE(other.amplitude, 1e-14);
    }
  }
}

// A free body in turning axes: K = −Ω²m, a double defective root at Ω. Its motion is a straight line at constant speed,
// in turning axes R(−Ωt)(q + (q̇ + Ω × q)t).
TEST(Response, FreeBodyInTurningAxesIsExact) {
  const double spin = 0.7, m = 3;
  const Matrix g{{0, -2 * m * spin}, {2 * m * spin, 0}};
  const System system(m * Matrix::Identity(2, 2), g, -m * spin * spin * Matrix::Identity(2, 2));
  const Eigen::Vector2d q(0.4, -1.1), v(0.2, 0.5), inertial = v + spin * Eigen::Vector2d(-q(1), q(0));
  const Response r(system, {q, v});
  EXPECT_EQ(r.remainder_size(), 4);
  for (const double t : {0.0, 1.0, 100.0, 1e4, 1e6}) {
    const Eigen::Vector2d line = q + t * inertial;
    const double c = std::cos(spin * t), sn = std::sin(spin * t);
    const Eigen::Vector2d exact(c * line(0) + sn * line(1), -sn * line(0) + c * line(1));
    EXPECT_LE((r.at(t).q - exact).norm(), 50 * epsilon * (1 + spin * t) * line.norm()) << t;
  }
}

TEST(Response, HasNoTimeBeforeItsStart) {
  const Response r(System(Matrix{{1}}, Matrix{{0}}, Matrix{{4}}), {Vector::Ones(1), Vector::Zero(1)});
  for (const double t : {-1.0, -1e-300, std::nan(""), infinity}) {
    EXPECT_THROW(r.at(t), InvalidArgument) << t;
    EXPECT_THROW(r.at(Vector::Constant(1, t)), InvalidArgument) << t;
  }
  EXPECT_EQ(r.at(0).q(0), 1);
}

// K = 0 in one direction: rest displaced, and drift linear in t for as long as one likes.
TEST(Response, DriftIsLinear) {
  const Matrix k{{2, -2, 0}, {-2, 3, -1}, {0, -1, 1}};
  for (const double gyro : {0.0, 0.8}) {
    Matrix g = Matrix::Zero(3, 3);
    g(0, 2) = gyro, g(2, 0) = -gyro;
    const System system(Eigen::Vector3d(1, 2, 3).asDiagonal(), g, k);
    const State start{Eigen::Vector3d(0.1, 0.2, -0.3), Eigen::Vector3d(1, -0.5, 0.25)};
    const Response r(system, start);
    for (const double t : {0.3, 7.0, 300.0}) {
      const State exact = exact_state(system, start, t);
      EXPECT_LE((r.at(t).q - exact.q).norm(), 1e-12 * (1 + t)) << gyro << " " << t;
    }
    const State far = r.at(1e9), exact = exact_state(system, start, 1e9);
    EXPECT_LE((far.q - exact.q).norm(), 1e-6 * exact.q.norm()) << gyro;
  }
}

TEST(Response, DivergenceFlutterAndDoubleRoots) {
  const auto rotating = [](double g, double k1, double k2) {
    return System(Matrix::Identity(2, 2), Matrix{{0, -g}, {g, 0}}, Matrix{{k1, 0}, {0, k2}});
  };
  Source s{std::mt19937_64(5)};
  for (const System& system :
       {rotating(0.5, -1, 4), rotating(2.9, -1, -4), rotating(3, -1, -4), rotating(3.1, -1, -4), rotating(3 + 1e-9, -1, -4)}) {
    const State start = random_state(s, 2);
    const Response r(system, start);
    for (const double t : {0.1, 1.0, 5.0, 20.0}) {
      const State exact = exact_state(system, start, t);
      EXPECT_LE(distance(r.at(t), exact, 1), 1e-11 * (1 + t) * size(exact, 1)) << system.gyroscopic()(1, 0) << " " << t;
    }
  }
}

// Any system the solvers know, whatever its class: the parts add up to the state, and motion is that of the
// exponential.
TEST(Response, RandomSystemsOfEveryClass) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto drawn = support::random_system(seed);
    if (drawn.mass.rows() > 6) continue;
    const System system = drawn.system();
    Source s{std::mt19937_64(seed)};
    const State start = random_state(s, system.size());
    const Response r(system, start);
    if (!r.balance_closed()) continue;
    const double fastest =
        std::max(std::sqrt(system.stiffness().norm() / system.mass().norm()), system.gyroscopic().norm() / system.mass().norm());
    if (!(fastest > 0)) continue;
    const State exact = exact_state(system, start, 3 / fastest);
    ++compared;
    EXPECT_LE(distance(r.at(3 / fastest), exact, fastest), 1e-7 * size(exact, fastest))
        << seed << ": " << drawn.description << ", departure " << r.departure();
  }
  EXPECT_GT(compared, 50);
}

TEST(Response, ForcesAgainstTheMatrixExponential) {
  Source s{std::mt19937_64(7)};
  for (int trial = 0; trial < 12; ++trial) {
    const Index n = 2 * s.integer(1, 3);
    const System system = stable_system(s, n, trial % 3 == 2);
    const State start = random_state(s, n);
    const Vector f = s.gaussian(n, 1);
    const Response free(system, start);
    const double fastest = free.modal().back().omega;
    // At a mode: the response grows as t.
    for (const double nu : {0.0, 0.37, free.modal()[0].omega}) {
      const Response r(system, start, {{nu == 0 ? Force::Course::step : Force::Course::harmonic, f, nu}});
      for (const double t : {0.2, 3.0, 50.0}) {
        const State exact = exact_state(system, start, f, nu, t);
        EXPECT_LE(distance(r.at(t), exact, fastest),
                  40 * static_cast<double>(n) * epsilon * (1 + fastest * t) * (size(exact, fastest) + f.norm() * t))
            << trial << " ν " << nu << " t " << t;
      }
    }
    const Response kicked(system, start, {{Force::Course::impulse, f, 0}});
    State after = start;
    after.qdot += small::inverse(system.mass()) * f;
    EXPECT_LE(distance(kicked.at(2), exact_state(system, after, 2), fastest), 1e-12 * size(after, fastest));
  }
}

TEST(Response, ForcesOnFreeAndGrowingMotion) {
  const System free(Eigen::Vector2d(2, 5).asDiagonal(), Matrix::Zero(2, 2), Matrix{{1, -1}, {-1, 1}});
  const System growing(Matrix::Identity(2, 2), Matrix{{0, -0.5}, {0.5, 0}}, Matrix{{-1, 0}, {0, 4}});
  const System flutter(Matrix::Identity(2, 2), Matrix{{0, -2.5}, {2.5, 0}}, Matrix{{-1, 0}, {0, -4}});
  const Vector f = Eigen::Vector2d(0.3, -0.7);
  for (const System& system : {free, growing, flutter}) {
    for (const State& start : {State{Vector::Zero(2), Vector::Zero(2)}, State{Eigen::Vector2d(0.1, 0.2), Eigen::Vector2d(-0.3, 0.4)}}) {
      for (const double nu : {0.0, 0.9}) {
        const Response r(system, start, {{nu == 0 ? Force::Course::step : Force::Course::harmonic, f, nu}});
        for (const double t : {0.5, 4.0, 12.0}) {
          const State exact = exact_state(system, start, f, nu, t);
          EXPECT_LE(distance(r.at(t), exact, 1), 1e-12 * (1 + t) * (size(exact, 1) + 1))
              << nu << " " << t << " " << system.stiffness()(0, 0);
        }
      }
    }
  }
}

// Drift beside a stiff coordinate, and in units far apart: the soft part of K must not be taken for rounding.
TEST(Response, DriftBesideStiffCoordinates) {
  Matrix g = Matrix::Zero(3, 3);
  g(1, 0) = 1e3, g(0, 1) = -1e3, g(2, 0) = 1, g(0, 2) = -1;
  const System system(Matrix::Identity(3, 3), g, Eigen::Vector3d(0, 1e12, 1).asDiagonal());
  const State start{Vector::Zero(3), Eigen::Vector3d(1, 0, 0)};
  const Response r(system, start);
  for (const double t : {1.0, 5.0}) {
    // The stiff coordinate follows: q1 and q3 with mass 1 + 1e-6 and G₃₁ alone.
    const double m = 1 + 1e-6, w = std::sqrt(1 + 1 / m);
    const double q1 = (t * w * w - (t - std::sin(w * t) / w) / m) / (w * w), q3 = -(1 - std::cos(w * t)) / (w * w);
    EXPECT_NEAR(r.at(t).q(0), q1, 2e-5) << t;
    EXPECT_NEAR(r.at(t).q(2), q3, 2e-5) << t;
  }
}

// A step force on a free mass in turning axes, for as long as one likes: the straight line of a steady force that
// turns.
TEST(Response, ForcedDoubleRootIsExact) {
  const double spin = 0.8, m = 100;
  const Matrix g{{0, -2 * m * spin}, {2 * m * spin, 0}};
  const System system(m * Matrix::Identity(2, 2), g, -m * spin * spin * Matrix::Identity(2, 2));
  const Response r(system, {Vector::Zero(2), Vector::Zero(2)}, {{Force::Course::step, Eigen::Vector2d(1, 0), 0}});
  for (const double t : {1.0, 1e3, 1e6}) {
    // z = inertial place turned back: z̈ + 2jΩż − Ω²z = f/m.
    const Complex j(0, 1), turned = std::polar(1.0, -spin * t);
    const Complex exact = 1 / m * (-1 / (spin * spin) + turned * (1 / (spin * spin) + j * t / spin));
    const State w = r.at(t);
    EXPECT_LE(std::abs(Complex(w.q(0), w.q(1)) - exact), 1e-13 * (1 + t) * std::abs(exact)) << t;
  }
}

// Coordinates q = d q̂ with d powers of two from 2⁻³⁰ to 2³⁰: the same motion, to the last bit of the accuracy.
System in_units(const System& s, const Vector& d) {
  return System(d.asDiagonal() * s.mass() * d.asDiagonal(), d.asDiagonal() * s.gyroscopic() * d.asDiagonal(),
                d.asDiagonal() * s.stiffness() * d.asDiagonal());
}
State in_units(const State& w, const Vector& d) { return {w.q.cwiseQuotient(d), w.qdot.cwiseQuotient(d)}; }
State back(const State& w, const Vector& d) { return {w.q.cwiseProduct(d), w.qdot.cwiseProduct(d)}; }

Vector random_units(Source& s, Index n) {
  Vector d(n);
  for (double& x : d) x = std::exp2(static_cast<double>(s.integer(-30, 30)));
  return d;
}

// One growing motion and undamped ones in coordinates that show neither; moved along the undamped ones, by states and
// forces, the remainder is rounding and stays rounding times e^{σt}.
TEST(Response, RemainderOfRoundingStaysRounding) {
  Source s{std::mt19937_64(11)};
  for (int trial = 0; trial < 24; ++trial) {
    const Index n = s.integer(3, 7);
    const double growth = 0.8, stiff = trial % 2 == 0 ? 4 : 1e6;
    Vector squares = Vector::LinSpaced(n, 1, stiff);
    squares(0) = -growth * growth;
    const Matrix q = s.orthogonal(n);
    const System base(Matrix::Identity(n, n), Matrix::Zero(n, n), symmetric_part(q * squares.asDiagonal() * q.transpose()));
    const Vector d = trial % 3 == 0 ? Vector(Vector::Ones(n)) : random_units(s, n);
    const State start{q.rightCols(n - 1) * s.gaussian(n - 1, 1), q.rightCols(n - 1) * s.gaussian(n - 1, 1)};
    const Vector f = q.rightCols(n - 1) * s.gaussian(n - 1, 1);
    const double nu = trial % 4 == 1 ? 0 : 0.9;
    for (const bool at_rest : {false, true}) {
      const State from = at_rest ? State::rest(n) : start;
      const Response r(in_units(base, d), in_units(from, d),
                       {{nu == 0 ? Force::Course::step : Force::Course::harmonic, d.asDiagonal() * f, nu},
                        {Force::Course::impulse, d.asDiagonal() * f, 0}});
      EXPECT_TRUE(r.balance_closed());
      EXPECT_LE(r.departure(), 1e-12 * std::sqrt(stiff)) << trial;
      State kicked = from;
      kicked.qdot += f;
      for (const double t : {0.5, 8.0, 20.0}) {
        const State exact = exact_state(base, kicked, f, nu, t);
        const double bar = 100 * static_cast<double>(n) * epsilon * std::exp(growth * t) * stiff * (1 + t);
        EXPECT_LE(distance(back(r.at(t), d), exact, 1), bar * (size(kicked, 1) + f.norm()))
            << "trial " << trial << ", t " << t << ", at rest " << at_rest;
      }
    }
  }
}

// A pair of growth, a double root and modes in one component: what is in the remainder is followed there, forces alone
// are judged too.
TEST(Response, RemainderBesideModes) {
  Source s{std::mt19937_64(12)};
  for (int trial = 0; trial < 12; ++trial) {
    Matrix g = Matrix::Zero(5, 5);
    g(0, 1) = -1.6, g(1, 0) = 1.6, g(2, 3) = 0.7, g(3, 2) = -0.7;
    const Vector k{{-0.64, -0.64, 3, 5, trial % 2 == 0 ? -0.5 : 2}};
    const Matrix q = s.orthogonal(5);
    const System base(Matrix::Identity(5, 5), skew_part(q * g * q.transpose()), symmetric_part(q * k.asDiagonal() * q.transpose()));
    const Vector d = random_units(s, 5), f = s.gaussian(5, 1);
    const State start = random_state(s, 5);
    for (const bool at_rest : {false, true}) {
      const State from = at_rest ? State::rest(5) : start;
      const Response r(in_units(base, d), in_units(from, d), {{Force::Course::harmonic, d.asDiagonal() * f, 0.3}});
      EXPECT_GT(r.remainder_size(), 0);
      EXPECT_LE(r.departure(), 1e-7) << trial;
      for (const double t : {1.0, 6.0}) {
        const State exact = exact_state(base, from, f, 0.3, t);
        EXPECT_LE(distance(back(r.at(t), d), exact, 1), 1e-6 * (size(exact, 1) + f.norm())) << trial << " " << t;
      }
    }
  }
}

// Motion is linear: what moves by 2⁻⁶⁶⁰, whose square no number holds, moves the same. M = 1, a growing pair beside a
// mode.
TEST(Response, SmallMotionIsNoRounding) {
  const System system(Matrix::Identity(2, 2), Matrix{{0, -0.5}, {0.5, 0}}, Matrix{{-1, 0.3}, {0.3, 4}});
  const double small = std::exp2(-660);
  const State start{Eigen::Vector2d(0.3, -0.2), Eigen::Vector2d(0.1, 0.7)};
  const Vector f = Eigen::Vector2d(0.4, -1);
  const Response large(system, start, {{Force::Course::step, f, 0}}),
      tiny(system, {small * start.q, small * start.qdot}, {{Force::Course::step, small * f, 0}});
  EXPECT_EQ(tiny.remainder_size(), 2);
  for (const double t : {0.5, 5.0}) EXPECT_LE((tiny.at(t).q / small - large.at(t).q).norm(), 1e-15 * large.at(t).q.norm()) << t;
  EXPECT_NEAR(tiny.phase_error(1) / large.phase_error(1), 1, 1e-12);
}

// The phase error is of the size of the error there is, never much below it, in any units; and grows as t.
TEST(Response, PhaseErrorIsKnown) {
  Source s{std::mt19937_64(13)};
  for (int trial = 0; trial < 20; ++trial) {
    const Index n = 2 * s.integer(1, 4);
    const System base = stable_system(s, n, trial % 3 == 2);
    const Vector d = trial % 2 == 0 ? Vector(Vector::Ones(n)) : random_units(s, n);
    const State start = random_state(s, n);
    const Response r(in_units(base, d), in_units(start, d));
    const double fastest = r.modal().back().omega;
    EXPECT_DOUBLE_EQ(r.phase_error(1e12), 1e6 * r.phase_error(1e6));
    EXPECT_GT(r.phase_error(1e12 / fastest), 1e-6);
    EXPECT_LT(r.phase_error(1e3 / fastest), 1e-9);
    for (const double t : {1e3 / fastest, 1e6 / fastest, 1e9 / fastest}) {
      const State exact = exact_state(base, start, t);
      EXPECT_LE(distance(back(r.at(t), d), exact, fastest),
                (10 * r.phase_error(t) + 100 * static_cast<double>(n) * epsilon) * size(exact, fastest))
          << trial << " " << t;
    }
  }
  const System one(Matrix::Identity(1, 1), Matrix::Zero(1, 1), Matrix::Identity(1, 1));
  EXPECT_EQ(Response(one, State::rest(1)).phase_error(1e300), 0);  // nothing moves
  EXPECT_EQ(Response(one, State::rest(1)).departure(), 0);
  EXPECT_GT(Response(one, State::rest(1), {{Force::Course::step, Vector::Ones(1), 0}}).phase_error(1e12), 1e-6);
}

TEST(Response, WrongInput) {
  Source s{std::mt19937_64(9)};
  const System system = stable_system(s, 4, false);
  EXPECT_THROW(Response(system, {Vector::Zero(3), Vector::Zero(4)}), InvalidArgument);
  EXPECT_THROW(Response(system, {Vector::Constant(4, NAN), Vector::Zero(4)}), InvalidArgument);
  EXPECT_THROW(Response(system, {Vector::Zero(4), Vector::Zero(4)}, {{Force::Course::step, Vector::Zero(2), 0}}), InvalidArgument);
}
