// Every promise of System and FirstOrderSystem broken once, and the message read; what is accepted, and that no verdict
// depends on units.

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/status.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/scale.h"
#include "gyromode/system/system.h"
#include "gyromode/modes/modes.h"
#include "gyromode/system/laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace gyromode {
namespace {

constexpr double unit_scales[] = {1e-9, 1, 1e9};

struct Model {
  Matrix m, g, k;
  Labels labels = {};
};

// Two coordinates, everything coupled; the largest entry of G and K is 3.
Model good() { return {Matrix{{2, 1}, {1, 2}}, Matrix{{0, 3}, {-3, 0}}, Matrix{{1, 3}, {3, -1}}, {"x", "y"}}; }

std::string verdict(const Model& a) {
  try {
    System(a.m, a.g, a.k, a.labels);
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

std::string first_order_verdict(const Model& a) {
  try {
    FirstOrderSystem(a.m, a.g, a.labels);
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

struct Departure {
  Model model;
  std::string message;
};

template <class Change>
Departure broken(Change change, std::string message) {
  Model a = good();
  change(a);
  return {a, std::move(message)};
}

// Breaches in units: the same at every scale but for the entries quoted. `M` also reads as I, the inertia of first
// order.
std::vector<Departure> departures() {
  return {
      broken([](Model& a) { a.m.resize(2, 3); }, "M must be square: it has 2 rows and 3 columns"),
      broken([](Model& a) { a.m.resize(0, 0); }, "M must have at least one coordinate: it is empty"),
      broken([](Model& a) { a.m(0, 1) = infinity; }, "M must be finite: entry (1,2) = inf"),
      broken([](Model& a) { a.m(1, 0) = -infinity; }, "M must be finite: entry (2,1) = -inf"),
      broken([](Model& a) { a.m(0, 1) = 1.25; },
             "M must satisfy M = Mᵀ: entries (1,2) = 1.25 and (2,1) = 1 differ by 0.25, 12 % of the largest entry"),
      broken([](Model& a) { a.m(1, 1) = 0; }, "M must be positive definite: diagonal entry (2,2) = 0 of coordinate 'y' is not above 0"),
      broken([](Model& a) { a.m(0, 0) = -4; }, "M must be positive definite: diagonal entry (1,1) = -4 of coordinate 'x' is not above 0"),
      broken(
          [](Model& a) {
            a.m = Matrix{{1, 1}, {1, 1}};
          },
          "M must be positive definite: scaled to unit diagonal its smallest eigenvalue is 0, not above n ε = 4.4e-16; coordinate 'x' "
          "takes part most"),
      broken(
          [](Model& a) {
            a.m = Matrix{{1, 2}, {2, 1}};
          },
          "M must be positive definite: scaled to unit diagonal its smallest eigenvalue is -1, not above n ε = 4.4e-16; coordinate 'x' "
          "takes part most"),
      broken(
          [](Model& a) {
            a.m = Matrix{{1, 1}, {1, 1 + epsilon}};
          },
          "M must be positive definite: scaled to unit diagonal its smallest eigenvalue is 1.11e-16, not above n ε = 4.4e-16; coordinate "
          "'x' takes part most"),
      broken([](Model& a) { a.g.resize(3, 2); }, "G must be square: it has 3 rows and 2 columns"),
      broken([](Model& a) { a.g.resize(0, 0); }, "G must have at least one coordinate: it is empty"),
      broken([](Model& a) { a.g = Matrix::Zero(3, 3); }, "G must have the order of M: it is 3 × 3, M is 2 × 2"),
      broken([](Model& a) { a.g(1, 1) = std::nan(""); }, "G must be finite: entry (2,2) = nan"),
      broken([](Model& a) { a.g(1, 0) = -2.5; },
             "G must satisfy G = −Gᵀ: entries (1,2) = 3 and (2,1) = -2.5 miss opposite signs by 0.5, 17 % of the largest entry"),
      broken([](Model& a) { a.g(1, 0) = 3; },
             "G must satisfy G = −Gᵀ: entries (1,2) = 3 and (2,1) = 3 miss opposite signs by 6, 2e+02 % of the largest entry"),
      broken([](Model& a) { a.g(1, 1) = 1.5; },
             "G must satisfy G = −Gᵀ: the diagonal entry (2,2) = 1.5 must be 0, it is 50 % of the largest entry"),
      broken([](Model& a) { a.labels = {"x"}; }, "labels must name every coordinate once: 1 labels for 2 coordinates"),
      broken(
          [](Model& a) {
            a.labels = {"x", ""};
          },
          "labels must not be empty"),
      broken(
          [](Model& a) {
            a.labels = {"x", "y\x1b[31m"};
          },
          "labels must print on one line: one has a control character"),
      broken(
          [](Model& a) {
            a.labels = {"tilt", "tilt"};
          },
          "labels must differ: 'tilt' is given twice"),
  };
}

std::vector<Departure> departures_of_stiffness() {
  return {
      broken([](Model& a) { a.k.resize(2, 1); }, "K must be square: it has 2 rows and 1 columns"),
      broken([](Model& a) { a.k.resize(0, 0); }, "K must have at least one coordinate: it is empty"),
      broken([](Model& a) { a.k = Matrix::Zero(1, 1); }, "K must have the order of M: it is 1 × 1, M is 2 × 2"),
      broken([](Model& a) { a.k(1, 0) = std::nan(""); }, "K must be finite: entry (2,1) = nan"),
      broken([](Model& a) { a.k(1, 0) = 2.5; },
             "K must satisfy K = Kᵀ: entries (1,2) = 3 and (2,1) = 2.5 differ by 0.5, 17 % of the largest entry"),
  };
}

std::string of_first_order(std::string message) {  // M is called I there
  for (const char* place : {"M must", "M = M", "of M", ", M is"}) {
    for (std::size_t at = 0; (at = message.find(place, at)) != std::string::npos; ++at) {
      for (std::size_t i = at; i < at + std::string(place).size(); ++i) message[i] = message[i] == 'M' ? 'I' : message[i];
    }
  }
  return message;
}

// The law broken and the relative size, without the quoted entries.
std::string promise(const std::string& message) {
  const std::size_t law = message.find(": "), size = message.rfind(", ");
  return message.substr(0, law) + (size != std::string::npos && message.find('%') != std::string::npos ? message.substr(size) : "");
}

TEST(System, GoodModelsAreAcceptedAndKept) {
  ASSERT_EQ(verdict(good()), "accepted");
  const Model a = good();
  const System s(a.m, a.g, a.k, a.labels);
  EXPECT_TRUE(s.size() == 2 && s.mass() == a.m && s.gyroscopic() == a.g && s.stiffness() == a.k && s.labels() == a.labels);
  EXPECT_EQ(System(a.m, a.g, a.k).labels(), (Labels{"q1", "q2"}));
  const ComplexMatrix h = s.impedance(2);  // K − 4M + 2jG
  EXPECT_TRUE(h == (ComplexMatrix(2, 2) << -7, Complex(-1, 6), Complex(-1, -6), -9).finished());
  EXPECT_EQ(verdict({Matrix{{1}}, Matrix{{0}}, Matrix{{0}}}), "accepted");  // one free coordinate
}

TEST(FirstOrderSystem, GoodModelsAreAcceptedAndKept) {
  const Model a = good();
  ASSERT_EQ(first_order_verdict(a), "accepted");
  const FirstOrderSystem s(a.m, a.g);
  EXPECT_TRUE(s.size() == 2 && s.inertia() == a.m && s.gyroscopic() == a.g && s.labels() == (Labels{"q1", "q2"}));
  EXPECT_TRUE(s.impedance(2) == (ComplexMatrix(2, 2) << 4, Complex(2, -3), Complex(2, 3), 4).finished());  // 2I − jG
}

// Without what the matrices may be instead (test_diagnosis.cpp).
std::string without_diagnosis(const std::string& message) { return message.substr(0, message.find("; its ")); }

TEST(System, BrokenPromisesNameLawSizeAndPlace) {
  for (const auto& [model, message] : departures()) EXPECT_EQ(without_diagnosis(verdict(model)), message);
  for (const auto& [model, message] : departures_of_stiffness()) EXPECT_EQ(without_diagnosis(verdict(model)), message);
}

TEST(FirstOrderSystem, BrokenPromisesNameLawSizeAndPlace) {
  for (const auto& [model, message] : departures()) EXPECT_EQ(first_order_verdict(model), of_first_order(message));
}

TEST(System, VerdictsDoNotDependOnTheUnitOfMass) {
  auto all = departures();
  for (auto& b : departures_of_stiffness()) all.push_back(b);
  all.push_back({good(), "accepted"});
  for (const double unit : unit_scales) {
    for (const auto& [model, message] : all) {
      EXPECT_EQ(promise(without_diagnosis(verdict({unit * model.m, unit * model.g, unit * model.k, model.labels}))), promise(message))
          << "unit " << unit;
    }
  }
}

TEST(System, LargestBreachIsTheOneReported) {
  Matrix k = Matrix::Identity(4, 4);
  k(0, 1) = 0.1;
  k(3, 2) = -0.3;
  EXPECT_EQ(without_diagnosis(verdict({Matrix::Identity(4, 4), Matrix::Zero(4, 4), k})),
            "K must satisfy K = Kᵀ: entries (3,4) = 0 and (4,3) = -0.3 differ by 0.3, 30 % of the largest entry");
}

// 8 ε of rounding against a largest entry of 4: an error of 2 ε, half of it on either side.
TEST(System, RoundingIsTakenAsSymmetricAndReported) {
  for (const double unit : {0x1p-30, 1.0, 0x1p30}) {
    const Matrix m{{4, 1}, {1 + 8 * epsilon, 4}}, g{{0, 4}, {-4 - 16 * epsilon, 0}}, k{{4, 1 - 8 * epsilon}, {1, 0}};
    const System s(unit * m, unit * g, unit * k);
    ASSERT_EQ(s.repairs().size(), 3U);
    EXPECT_EQ(s.repairs()[0].own_scale, 2 * epsilon);
    EXPECT_NEAR(s.repairs()[1].own_scale, 4 * epsilon, epsilon * epsilon * 100);
    EXPECT_EQ(s.repairs()[2].own_scale, 4 * epsilon);  // 8 ε over √(4·1)
    EXPECT_EQ(s.repairs()[2].departure, 2 * epsilon);
    EXPECT_TRUE(s.repairs()[2].matrix == "K" && s.repairs()[2].row == 1 && s.repairs()[2].column == 0);
    EXPECT_EQ((*s.repairs()[2].dropped)(0, 1), -unit * 4 * epsilon);
    EXPECT_EQ(s.mass()(0, 1), unit * (1 + 4 * epsilon));
    EXPECT_TRUE(s.mass() == s.mass().transpose() && s.gyroscopic() == -s.gyroscopic().transpose() &&
                s.stiffness() == s.stiffness().transpose());
    const FirstOrderSystem f(unit * m, unit * g);
    EXPECT_EQ(f.repairs().front().own_scale, 2 * epsilon);
    EXPECT_TRUE(f.inertia() == s.mass() && f.gyroscopic() == s.gyroscopic());
  }
  const System exact(good().m, good().g, good().k);
  EXPECT_TRUE(exact.repairs().empty());
}

// 1e-8 of the rows an entry is in, or 1e-12 of the largest entry.
TEST(System, RoundingHasItsLimits) {
  for (const double unit : unit_scales) {
    const auto with = [&](double departure, double stiffest, Admission admission) {
      try {
        const Matrix k = Eigen::Vector3d(1, 1, stiffest).asDiagonal();
        Matrix off = k;
        off(1, 0) = departure;
        System(unit * Matrix::Identity(3, 3), Matrix::Zero(3, 3), unit * off, {}, admission);
        return true;
      } catch (const LawBroken&) {
        return false;
      }
    };
    EXPECT_TRUE(with(0.99e-8, 1, {}) && !with(1.01e-8, 1, {}));
    EXPECT_TRUE(with(0.99e-8, 1e-6, {}) && !with(1.01e-8, 1e-6, {}));
    EXPECT_TRUE(with(0.99e-6, 1e6, {}) && !with(1.01e-6, 1e6, {}));
    EXPECT_TRUE(with(0, 1, {.strict = true}) && !with(1e-300, 1, {.strict = true}) && !with(1e-16, 1, {.strict = true}));
    EXPECT_TRUE(with(0.1, 1, {.symmetrise = 0.11}) && !with(0.1, 1, {.symmetrise = 0.09}) && with(0.1, 10, {.symmetrise = 0.011}));
    EXPECT_TRUE(!with(0.1, 1, {.strict = true, .symmetrise = 1}));
  }
}

// M = SᵀDS with S an integer matrix of determinant 1: positive definite where D > 0, and not where an entry of D is
// negative. Then every coordinate gets a unit of its own, over 12 decades.
TEST(System, MassIsJudgedAlikeInMixedUnits) {
  std::mt19937_64 random(21);
  std::uniform_int_distribution<int> digit(-1, 1), sign(0, 1);
  std::uniform_real_distribution<double> exponent(-6, 6);
  for (int trial = 0; trial < 200; ++trial) {
    const Index n = 1 + trial % 8;
    Matrix s = Matrix::Identity(n, n), d = Matrix::Identity(n, n), t(n, n);
    for (Index j = 0; j < n; ++j) {
      for (Index i = j + 1; i < n; ++i) s(i, j) = digit(random);
    }
    const bool definite = trial % 2 == 0;
    if (!definite) d(trial % n, trial % n) = -1;
    t = Vector::NullaryExpr(n, [&] { return std::pow(10, exponent(random)); }).asDiagonal();
    for (const double unit : unit_scales) {
      const Matrix m = unit * symmetric_part(t * s.transpose() * d * s * t);
      const std::string says = verdict({m, Matrix::Zero(n, n), m});
      EXPECT_EQ(promise(says), definite ? "accepted" : "M must be positive definite");
    }
  }
}

// ---- known not to hold yet

TEST(System, SingularMassIsRefused) {  // M(5, −3, −1)ᵀ = 0; the last pivot is 2e-15, above 3 ε
  EXPECT_NE(verdict({Matrix{{2, 3, 1}, {3, 5, 0}, {1, 0, 5}}, Matrix::Zero(3, 3), Matrix::Zero(3, 3)}), "accepted");
}

TEST(System, MassIsJudgedAlikeInEveryOrderOfCoordinates) {  // M = L Lᵀ, L unit lower with −1 below: λ_min ≈ 4⁻³⁰
  Matrix l = -Matrix::Ones(30, 30).triangularView<Eigen::StrictlyLower>().toDenseMatrix() + Matrix::Identity(30, 30);
  const Matrix m = l * l.transpose(), zero = Matrix::Zero(30, 30);
  EXPECT_EQ(verdict({m, zero, zero}) == "accepted", verdict({m.reverse(), zero, zero}) == "accepted");
}

TEST(System, AsymmetryIsSeenInMixedUnits) {  // refused in equal units; beside a stiffness of 1e12 let in, and never as if it were nothing
  const Matrix k{{1, 0, 0}, {0, 1, 0.5}, {0, -0.5, 1}}, t = Eigen::Vector3d(1e6, 1e-2, 1e-2).asDiagonal();
  EXPECT_NE(verdict({Matrix::Identity(3, 3), Matrix::Zero(3, 3), k}), "accepted");
  const System s(t * t, Matrix::Zero(3, 3), t * k * t);
  ASSERT_EQ(s.repairs().size(), 1U);
  EXPECT_EQ(s.repairs().front().own_scale, 1);
  const ModesResult r = find_modes(s);  // λ² = −1 ± j/2
  EXPECT_EQ(r.stability, Stability::unknown);
  EXPECT_NEAR(r.repairs.front().largest_effect.value_or(0), 0.25, 0.01);
}

TEST(System, WhatIsFiniteStaysFinite) {  // ½(A + Aᵀ) overflows
  const Matrix m = 1.5e308 * Matrix::Identity(2, 2);
  EXPECT_TRUE(System(m, Matrix::Zero(2, 2), m).mass().allFinite());
}

// ---- the scalings behind the verdicts

TEST(Scale, DiagonalAndRowsComeNearOneByPowersOfTwo) {
  std::mt19937_64 random(22);
  std::normal_distribution<double> normal;
  for (Index n = 1; n < 12; ++n) {
    Matrix a = Matrix::NullaryExpr(n, n, [&] { return normal(random); });
    const Matrix t = Vector::NullaryExpr(n, [&] { return std::pow(10, 3 * normal(random)); }).asDiagonal();
    a = t * a * a.transpose() * t;
    const Vector d = unit_diagonal_scale(a), e = equilibrating_scale(a);
    for (Index i = 0; i < n; ++i) {
      for (const double x : {d(i), e(i)}) EXPECT_EQ(std::exp2(std::round(std::log2(x))), x);
      EXPECT_TRUE(scaled(a, d)(i, i) >= 0.5 && scaled(a, d)(i, i) <= 2) << scaled(a, d)(i, i);
      const double row = scaled(a, e).row(i).cwiseAbs().maxCoeff();
      EXPECT_TRUE(row >= 0.25 && row <= 4) << row;
    }
    EXPECT_TRUE(equilibrating_scale(ComplexMatrix(a.cast<Complex>() * Complex(0, 1))) == e);
  }
  EXPECT_TRUE(equilibrating_scale(Matrix(Matrix::Zero(2, 2))) == Vector::Ones(2));
  EXPECT_TRUE(unit_diagonal_scale(Matrix::Zero(2, 2)) == Vector::Ones(2));
  EXPECT_EQ(norm1(Matrix(0, 0)), 0);
  EXPECT_EQ(norm1(Matrix{{1, -2}, {3, 4}}), 6);
  EXPECT_TRUE(power_of_two_near(0) == 1 && power_of_two_near(3) == 4 && power_of_two_near(0.7) == 0.5);
}

// No matrix of that order is made for it.
TEST(LargestOrder, IsWhatDenseSolversTake) {
  EXPECT_NO_THROW(require_order("a model", most_coordinates));
  EXPECT_LT(8.0 * most_coordinates * most_coordinates + 12.0 * most_coordinates + 1, std::exp2(31));
  EXPECT_GT(8.0 * (most_coordinates + 1) * (most_coordinates + 1) + 12.0 * (most_coordinates + 1) + 1, std::exp2(31));
  try {
    require_order("a model", 20'000);
    ADD_FAILURE() << "accepted";
  } catch (const TooLarge& e) {
    EXPECT_STREQ(e.what(),
                 "a model of order 20000 is too large: dense models have at most 16383 coordinates; leave coordinates out, or solve parts "
                 "that nothing couples one by one");
  }
}

}  // namespace
}  // namespace gyromode
