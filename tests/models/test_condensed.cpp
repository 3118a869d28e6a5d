// Models with coordinates that have no mass: roots of the whole in 100 digits, shapes that satisfy the whole equations.
#include "gyromode/base/error.h"
#include "gyromode/models/model.h"
#include "gyromode/models/model_kind.h"
#include "reference/characteristic_root.h"
#include "support/random_matrices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace gyromode {
namespace {

using support::Source;

struct Whole {
  Matrix m, g, k;
  std::vector<Index> massless;
};

// s coordinates at random places without mass, what holds them 10^stiff times the rest.
Whole whole(Source& source, Index n, Index s, double stiff) {
  Whole w{source.symmetric(n, 0), source.skew(n), source.symmetric(n, 0), {}};
  std::vector<Index> order(static_cast<std::size_t>(n));
  for (Index i = 0; i < n; ++i) order[static_cast<std::size_t>(i)] = i;
  std::shuffle(order.begin(), order.end(), source.bits);
  w.massless.assign(order.begin(), order.begin() + s);
  for (const Index i : w.massless) {
    w.m.row(i).setZero();
    w.m.col(i).setZero();
    for (const Index j : w.massless) w.g(i, j) = 0;
  }
  const double unit = std::pow(10, stiff / 2);
  for (const Index i : w.massless) {
    w.k.row(i) *= unit;
    w.k.col(i) *= unit;
    w.g.row(i) *= unit;
    w.g.col(i) *= unit;
  }
  return w;
}

Model model_of(const Whole& w) { return Model(SpinFamily{w.m, w.g, Matrix::Zero(w.m.rows(), w.m.rows()), w.k, {}, {}, {}}, 0.0); }

TEST(Condensed, RootsAndShapesAreThoseOfTheWhole) {
  Source source{std::mt19937_64(5)};
  double closest = 0;
  for (int draw = 0; draw < 300; ++draw) {
    const Index n = source.integer(2, 8), s = source.integer(1, std::max<Index>(1, n / 2));
    const Whole w = whole(source, n, s, static_cast<double>(source.integer(-12, 12)));
    Model model = model_of(w);
    EXPECT_EQ(model.body->massless().size(), static_cast<std::size_t>(s));
    ModesOptions options;
    options.shapes = true;
    const ModesResult r = model.modes(options);
    EXPECT_EQ(static_cast<Index>(r.modes.size()), n - s);  // K > 0
    EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
    for (const Mode& m : r.modes) {
      const double distance = reference::distance_to_root(w.m, w.g, w.k, Complex(0, m.omega));
      EXPECT_LE(distance, m.error_bound + 2e-16 * m.omega) << "draw " << draw << ", n " << n << ", " << s << " massless, ω = " << m.omega;
      closest = std::max(closest, distance / (m.error_bound + 2e-16 * m.omega));
      ASSERT_EQ(m.shape.size(), n);
      const ComplexVector rest = (w.k - m.omega * m.omega * w.m) * m.shape + Complex(0, m.omega) * (w.g * m.shape);
      const Vector terms = (w.k.cwiseAbs() + m.omega * w.g.cwiseAbs() + m.omega * m.omega * w.m.cwiseAbs()) * m.shape.cwiseAbs();
      for (Index i = 0; i < n; ++i) EXPECT_LE(std::abs(rest(i)), 1e-10 * terms.maxCoeff()) << draw;
      const Complex form = m.shape.dot((2 * m.omega) * (w.m * m.shape) - Complex(0, 1) * (w.g * m.shape));
      EXPECT_NEAR(m.form, form.real(), 1e-9 * std::abs(form)) << draw;
    }
  }
  std::printf("largest distance over bound: %.3g\n", closest);
}

// Disc on a housing without mass: K' = k₁k₂/(k₁ + k₂). The housing's stiffness varied: where it is −k₁ the disc is
// free.
TEST(Condensed, DiscOnAHousing) {
  Whole w{Matrix{{10, 0}, {0, 0}}, Matrix::Zero(2, 2), Matrix{{1000, -1000}, {-1000, 3000}}, {1}};
  const Model model = model_of(w);
  EXPECT_NEAR(model.modes().frequencies().at(0), std::sqrt(200.0 / 3), 1e-15);
  const Model softer = model.with({{"stiffness[1][1]", 2000}});
  EXPECT_NEAR(softer.modes().frequencies().at(0), std::sqrt(50.0), 1e-14);
  EXPECT_NEAR(model.with({{"mass[1][1]", 1e-9}}).modes().frequencies().at(0), std::sqrt(200.0 / 3), 1e-9);  // no condensed model any more
  EXPECT_THROW(model.with({{"stiffness[1][1]", 0}}), LawBroken);

  MotionRequest request;
  request.initial = State::rest(2);
  request.initial.q(0) = 1;
  request.times = Vector::LinSpaced(4, 0, 0.3);
  const ResponseReport motion = model.response(request);
  for (Index k = 0; k < 4; ++k) {
    const double x = std::cos(std::sqrt(200.0 / 3) * request.times(k));
    EXPECT_NEAR(motion.history.q(0, k), x, 1e-14);
    EXPECT_NEAR(motion.history.q(1, k), x / 3, 1e-14);
  }
  request.initial.q(1) = 1;
  EXPECT_THROW(model.response(request), NotApplicable);
}

// λ enters the massless coordinate's equation through G: K_ss s + λG_sm m = 0 gives M' = 1 + g²/k.
TEST(Condensed, GyroscopicCouplingAddsMass) {
  const Whole w{Matrix{{1, 0}, {0, 0}}, Matrix{{0, 2}, {-2, 0}}, Matrix{{9, 0}, {0, 4}}, {1}};
  EXPECT_NEAR(model_of(w).modes().frequencies().at(0), 3 / std::sqrt(2.0), 1e-15);
}

// What was not symmetric is told, whether or not coordinates are condensed.
TEST(Condensed, RepairsAreTold) {
  Whole w{Matrix{{10, 0}, {0, 0}}, Matrix::Zero(2, 2), Matrix{{1000, -1000 * (1 + 1e-10)}, {-1000, 3000}}, {1}};
  const ModesResult r = model_of(w).modes();
  ASSERT_EQ(r.repairs.size(), 1U);
  EXPECT_TRUE(r.repairs.front().matrix == "K" && r.repairs.front().row == 1 && r.repairs.front().column == 0);
  EXPECT_EQ(r.remarks().size(), 1U);
  EXPECT_EQ(model_of(w).structure().repairs.size(), 1U);
}

// Departures in K or in the massive part of G, of K of any index: what is stated against the roots of the whole as
// given, in 100 digits.
TEST(Condensed, EffectOfRepairs) {
  Source source{std::mt19937_64(11)};
  double least = 1e300, most = 0;
  int compared = 0;
  for (int draw = 0; draw < 120; ++draw) {
    const Index n = source.integer(3, 7), s = source.integer(1, n / 2);
    Whole w = whole(source, n, s, static_cast<double>(source.integer(-2, 2)));
    if (draw % 4 == 3) w.k -= 0.6 * w.m;  // of some index
    Matrix& changed = draw % 2 == 0 ? w.k : w.g;
    const double size = std::pow(10, -9 - draw % 5);
    for (Index i = 0; i < n; ++i) {
      for (Index j = 0; j < n; ++j) {
        const bool none = i == j || (draw % 2 == 1 && (w.m(i, i) == 0 || w.m(j, j) == 0));
        if (!none) changed(i, j) += size * changed.cwiseAbs().maxCoeff() * source.gaussian(1, 1)(0, 0);
      }
    }
    w.massless.clear();
    const ModesResult r = Model(SpinFamily{w.m, w.g, Matrix::Zero(n, n), w.k, {}, {}, {.symmetrise = 1e-6}}, 0.0).modes();
    ASSERT_EQ(r.repairs.size(), 1U);
    double truth = 0;
    for (const Mode& m : r.modes) truth = std::max(truth, reference::moved_by_asymmetry(w.m, w.g, w.k, Complex(0, m.omega)));
    for (const UnstableMode& u : r.unstable)
      truth = std::max(truth, reference::moved_by_asymmetry(w.m, w.g, w.k, Complex(u.growth_rate, u.omega)));
    const double stated = r.repairs.front().largest_effect.value_or(-1);
    EXPECT_GE(stated, truth) << draw;
    EXPECT_LE(stated, 10 * truth) << draw;
    least = std::min(least, stated / truth);
    most = std::max(most, stated / truth);
    ++compared;
  }
  std::printf("%d compared, stated / true from %.9f to %.9f\n", compared, least, most);
}

// The massless coordinate alone brings what is of second order: K departs between it and the mass.
TEST(Condensed, RepairsOfSecondOrderByMasslessCoordinates) {
  for (const double n : {1e-4, 1e-7}) {
    const Matrix m{{1, 0}, {0, 0}}, g = Matrix::Zero(2, 2), k{{4, n}, {-n, 5}};
    const ModesResult r = Model(SpinFamily{m, g, g, k, {}, {}, {.symmetrise = 1e-3}}, 0.0).modes();
    ASSERT_EQ(r.repairs.size(), 1U);
    EXPECT_NEAR(r.repairs.front().largest_effect.value_or(-1), n * n / 20, 2e-3 * n * n / 20);  // ω² = 4 + n²/5
  }
}

std::string said_of(const Whole& w) {
  try {
    model_of(w);
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Condensed, RefusalsNameTheCoordinates) {
  const Matrix m = Eigen::Vector3d(1, 0, 0).asDiagonal();
  const Matrix free{{2, -1, 0}, {-1, 1, 0}, {0, 0, 0}}, together{{2, -1, 0}, {-1, 3, -3}, {0, -3, 3}};
  EXPECT_NE(said_of({m, Matrix::Zero(3, 3), free, {}}).find("'q3' has neither mass nor"), std::string::npos);
  EXPECT_NE(said_of({m, Matrix::Zero(3, 3), together, {}}).find("'q2', 'q3' have neither mass nor"), std::string::npos);
  Matrix g = Matrix::Zero(3, 3);
  g(1, 2) = 1;
  g(2, 1) = -1;
  EXPECT_NE(said_of({m, g, Matrix(Eigen::Vector3d(1, 2, 3).asDiagonal()), {}}).find("couples 'q2', 'q3'"), std::string::npos);
  EXPECT_NE(said_of({Matrix::Zero(3, 3), Matrix::Zero(3, 3), free, {}}).find("no coordinate has mass"), std::string::npos);
}

}  // namespace
}  // namespace gyromode
