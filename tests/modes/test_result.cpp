// The conventions of a ModesResult: shapes, windows, what "lowest" means, the counts, and the refusals.
#include "support/random_system.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/modes/modes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace gyromode {
namespace {

// Uncoupled oscillators: ω_i² = k_i exactly.
System oscillators(const Vector& k) {
  return System(Matrix::Identity(k.size(), k.size()), Matrix::Zero(k.size(), k.size()), k.asDiagonal());
}

// 1, 2, 3, 4, 5 rad/s.
System ladder() { return oscillators(Vector{{1, 4, 9, 16, 25}}); }

// (1, 2) coupled by G, k₁, k₂ of any sign.
System pair(double k1, double k2, double g) {
  Matrix gyroscopic = Matrix::Zero(2, 2);
  gyroscopic(0, 1) = -g;
  gyroscopic(1, 0) = g;
  return System(Matrix::Identity(2, 2), gyroscopic, Vector{{k1, k2}}.asDiagonal());
}

// No partition: an odd cycle of three gyroscopic couplings.
System triangle(double k) {
  Matrix g = Matrix::Zero(3, 3);
  g << 0, 1, 2, -1, 0, 3, -2, -3, 0;
  return System(Matrix::Identity(3, 3), g, Vector{{k, 2, 3}}.asDiagonal());
}

ModesResult in_window(const System& s, double a, double b) {
  ModesOptions options;
  options.window = {a, b};
  return find_modes(s, options);
}

ModesResult lowest(const System& s, Index count) {
  ModesOptions options;
  options.lowest = count;
  return find_modes(s, options);
}

Vector frequencies(const ModesResult& r) {
  Vector w(static_cast<Index>(r.modes.size()));
  for (std::size_t i = 0; i < r.modes.size(); ++i) w(static_cast<Index>(i)) = r.modes[i].omega;
  return w;
}

// The modes are those of `expected`, to rounding.
testing::AssertionResult has_modes(const ModesResult& r, const Vector& expected) {
  const Vector found = frequencies(r);
  if (found.size() == expected.size() && ((found - expected).array().abs() <= 1e-14 * (1 + expected.array())).all())
    return testing::AssertionSuccess();
  return testing::AssertionFailure() << "found " << found.transpose() << ", expected " << expected.transpose();
}

// ---- shapes

void expect_conventions(const ModesResult& r, const std::string& what) {
  for (const Mode& m : r.modes) {
    const Vector size = m.shape.cwiseAbs();
    ASSERT_TRUE(m.shape.allFinite()) << what;
    Index first_tie = 0;
    while (size(first_tie) < 1 - 1e-12) ++first_tie;
    EXPECT_EQ(m.shape(first_tie), Complex(1, 0)) << what << ": the first of the largest is exactly 1";
    EXPECT_LE(size.maxCoeff(), 1 + 2e-12) << what;
    for (const Complex& z : m.shape) EXPECT_FALSE(std::signbit(z.real()) && z.real() == 0) << what << ": no −0";
  }
}

TEST(Shapes, LargestEntryIsOneAndQuadratureIsExact) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const support::RandomSystem drawn = support::random_system(seed);
    ModesOptions options;
    options.shapes = true;
    const ModesResult r = find_modes(drawn.system(), options);
    expect_conventions(r, drawn.description);
    if (r.solver.find("did not convince") != std::string::npos) continue;
    for (const Component& c : r.structure.components) {
      if (!c.quadrature()) continue;
      for (const Mode& m : r.modes) {
        bool real_first = true, imaginary_first = true;  // (x, −jy), or j times that where the largest is in the second group
        for (const Index i : c.in_phase) {
          real_first &= m.shape(i).imag() == 0;
          imaginary_first &= m.shape(i).real() == 0;
        }
        for (const Index i : c.in_quadrature) {
          real_first &= m.shape(i).real() == 0;
          imaginary_first &= m.shape(i).imag() == 0;
        }
        EXPECT_TRUE(real_first || imaginary_first || m.omega == 0) << drawn.description << ", ω = " << m.omega;
      }
    }
  }
}

TEST(Shapes, FirstOfTiesAndNoneUnlessAsked) {
  ModesOptions options;
  options.shapes = true;
  const ModesResult r = find_modes(pair(4, 4, 1), options);  // circular whirl: (1, ±j)
  ASSERT_EQ(r.modes.size(), 2u);
  for (const Mode& m : r.modes) {
    EXPECT_EQ(m.shape(0), Complex(1, 0));
    EXPECT_EQ(m.shape(1).real(), 0);
    EXPECT_NEAR(std::abs(m.shape(1).imag()), 1, 1e-15);
  }
  EXPECT_LT(r.modes[0].shape(1).imag() * r.modes[1].shape(1).imag(), 0) << "one forward, one backward";
  EXPECT_EQ(find_modes(ladder()).modes[0].shape.size(), 0);
}

// ---- windows

TEST(Windows, HoldModesFromAUpToB) {
  EXPECT_TRUE(has_modes(in_window(ladder(), 1.5, 3.5), Vector{{2, 3}}));
  EXPECT_TRUE(has_modes(in_window(ladder(), 2.5, infinity), Vector{{3, 4, 5}}));
  EXPECT_EQ(in_window(ladder(), 5.5, infinity).modes.size(), 0u);
  EXPECT_EQ(in_window(ladder(), 0, 0.5).modes.size(), 0u);
  const ModesResult r = in_window(ladder(), 1.5, 3.5);
  EXPECT_EQ(r.coverage.window.a, 1.5);
  EXPECT_EQ(r.coverage.window.b, 3.5);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  EXPECT_TRUE(in_window(ladder(), 2.5, infinity).coverage.window.open());
  EXPECT_EQ(in_window(ladder(), 5.5, infinity).coverage.status, CoverageStatus::complete);
}

TEST(Windows, AnEndpointOnAModeIsMovedOutward) {
  const ModesResult r = in_window(ladder(), 2, 4);
  EXPECT_TRUE(has_modes(r, Vector{{2, 3, 4}}));
  EXPECT_LT(r.coverage.window.a, 2);
  EXPECT_GT(r.coverage.window.b, 4);
  EXPECT_NEAR(r.coverage.window.a, 2, 1e-12);
  EXPECT_NEAR(r.coverage.window.b, 4, 1e-12);
  EXPECT_EQ(r.coverage.requested.a, 2);
  EXPECT_EQ(r.coverage.requested.b, 4);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  EXPECT_EQ(*r.coverage.counted, 3);
  const CountResult c = count_modes(ladder(), {2, 4});
  EXPECT_EQ(c.count, 3);
  EXPECT_EQ(c.status, CountStatus::exact);
  EXPECT_EQ(c.window.a, r.coverage.window.a);
}

TEST(Windows, MustBeWindows) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Window w : {Window{-1, 2}, {2, 2}, {3, 2}, {infinity, infinity}, {nan, 2}, {0, nan}, {-0.5, infinity}}) {
    EXPECT_THROW(require_window(w), InvalidArgument) << w.a << ", " << w.b;
    EXPECT_THROW(in_window(ladder(), w.a, w.b), InvalidArgument);
    EXPECT_THROW(count_modes(ladder(), w), InvalidArgument);
  }
  EXPECT_NO_THROW(require_window({0, infinity}));
  EXPECT_NO_THROW(require_window({0, 1e-300}));
  try {
    require_window({3, 2});
    FAIL();
  } catch (const InvalidArgument& e) {
    EXPECT_STREQ(e.what(), "a window [a, b) needs 0 ≤ a < b: [3, 2) is none");
  }
}

// ---- lowest

TEST(Lowest, CountsVibrationsAndBringsRigidBodiesAlong) {
  EXPECT_TRUE(has_modes(lowest(ladder(), 2), Vector{{1, 2}}));
  EXPECT_TRUE(has_modes(lowest(ladder(), 5), Vector{{1, 2, 3, 4, 5}}));
  EXPECT_EQ(lowest(ladder(), 99).modes.size(), 5u);
  const System free = oscillators(Vector{{9, 0, 4, 0, 1}});
  const ModesResult r = lowest(free, 2);
  EXPECT_TRUE(has_modes(r, Vector{{0, 0, 1, 2}}));
  EXPECT_EQ(r.modes[0].kind, ModeKind::rigid_body);
  EXPECT_EQ(r.modes[2].kind, ModeKind::vibration);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
  EXPECT_EQ(*r.coverage.counted, 4);
}

TEST(Lowest, CoincidingModesComeTogether) {
  EXPECT_TRUE(has_modes(lowest(oscillators(Vector{{1, 4, 4, 4, 9}}), 2), Vector{{1, 2, 2, 2}}));
  EXPECT_TRUE(has_modes(lowest(oscillators(Vector{{4, 4, 4}}), 1), Vector{{2, 2, 2}}));
}

TEST(Lowest, StartsAtTheWindow) {
  ModesOptions options;
  options.window.a = 2.5;
  options.lowest = 2;
  EXPECT_TRUE(has_modes(find_modes(ladder(), options), Vector{{3, 4}}));
}

// A window's end is a promise as well: asked for modes below 2.5, "lowest 4" returns 3 and 4 rad/s too.
TEST(Lowest, StaysInTheWindow) {
  ModesOptions options;
  options.window = {0, 2.5};
  options.lowest = 4;
  EXPECT_TRUE(has_modes(find_modes(ladder(), options), Vector{{1, 2}}));
}

// "Only so many": none asked for, one returned.
TEST(Lowest, NoneIsRefused) { EXPECT_THROW(lowest(ladder(), 0), InvalidArgument); }

// ---- counts, kinds, signs

TEST(Result, EveryRootIsAccountedForAndCounted) {
  for (std::uint64_t seed = 1000; seed < 1600; ++seed) {
    const support::RandomSystem drawn = support::random_system(seed);
    const ModesResult r = find_modes(drawn.system());
    Index roots = 0;
    for (const Mode& m : r.modes) {
      roots += m.multiplicity;
      EXPECT_GE(m.omega, 0);
      if (m.omega == 0) {
        EXPECT_EQ(m.energy_sign, 0) << drawn.description;
      }
      if (m.kind == ModeKind::rigid_body) {
        EXPECT_EQ(m.omega, 0) << drawn.description;
      }
      if (m.omega == 0 && r.stiffness.definiteness() != Definiteness::indefinite) {
        EXPECT_EQ(m.kind, ModeKind::rigid_body) << drawn.description;
      }
      if (r.stiffness.definiteness() != Definiteness::indefinite && m.omega > 0) {
        EXPECT_EQ(m.energy_sign, 1) << drawn.description;
      }
    }
    for (const UnstableMode& u : r.unstable) {
      roots += u.flutter() ? 2 : 1;
      EXPECT_GT(u.growth_rate, 0) << drawn.description;
    }
    EXPECT_TRUE(std::is_sorted(r.modes.begin(), r.modes.end(), [](const Mode& a, const Mode& b) { return a.omega < b.omega; }));
    if (r.coverage.status != CoverageStatus::complete) continue;
    EXPECT_EQ(roots, drawn.mass.rows()) << drawn.description;
    EXPECT_EQ(r.coverage.found, static_cast<Index>(r.modes.size())) << drawn.description;
    EXPECT_EQ(*r.coverage.counted, r.coverage.found) << drawn.description;
    EXPECT_TRUE(r.coverage.reason.empty());
  }
}

TEST(Result, ZeroModesOfAnIndefiniteStiffnessAreNoRigidBodies) {
  const ModesResult r = find_modes(pair(-1, 0, 3));  // ω² = 8 of negative energy, and a pair of zero roots
  ASSERT_EQ(r.modes.size(), 2u);
  EXPECT_EQ(r.modes[0].omega, 0);
  EXPECT_EQ(r.modes[0].kind, ModeKind::vibration);
  EXPECT_EQ(r.modes[0].energy_sign, 0);
  EXPECT_NEAR(r.modes[1].omega, std::sqrt(8), 1e-14);
}

// K = TᵀK₀T ≥ 0 of rank 2 with NᵀGN = 0 exactly, T an integer matrix of condition 40: three pairs of zero roots (r = 3,
// s = 0 in theory (T10)). Found are two zero modes and a vibration of 1.5e-14 rad/s, "complete": NᵀΓN of the computed
// null vectors is above 8 n ε‖Γ‖.
TEST(Result, UncoupledNullSpaceInSkewCoordinates) {
  Matrix m(5, 5), g(5, 5), k(5, 5);
  m << 3, 1, 1, 1, 0, 1, 2, -2, 2, 0, 1, -2, 4, -2, -1, 1, 2, -2, 5, 2, 0, 0, -1, 2, 4;
  g << 0, -3, 5, 1, 1, 3, 0, 4, -1, -4, -5, -4, 0, 0, 6, -1, 1, 0, 0, -6, -1, 4, -6, 6, 0;
  k << 8, 6, -4, 4, 4, 6, 5, -4, 4, 4, -4, -4, 4, -4, -4, 4, 4, -4, 4, 4, 4, 4, -4, 4, 4;
  const ModesResult r = find_modes(System(m, g, k));
  EXPECT_EQ(std::count_if(r.modes.begin(), r.modes.end(), [](const Mode& mode) { return mode.omega == 0; }), 3);
  EXPECT_EQ(r.index_balance.zero, 3);
  for (const Mode& mode : r.modes) EXPECT_TRUE(mode.omega == 0 || mode.omega > 1e-3) << mode.omega;
}

TEST(Result, UnstableAndNegativeModesAreListedWhateverTheWindow) {
  const ModesResult divergence = in_window(pair(-4, 9, 0), 100, 200);
  ASSERT_EQ(divergence.unstable.size(), 1u);
  EXPECT_NEAR(divergence.unstable[0].growth_rate, 2, 1e-14);
  EXPECT_FALSE(divergence.unstable[0].flutter());
  EXPECT_EQ(divergence.modes.size(), 0u);
  EXPECT_EQ(divergence.stability, Stability::unstable);

  const ModesResult flutter = in_window(pair(-1, -1, 1), 100, 200);  // g < 2: λ = ½√3 ± j½
  ASSERT_EQ(flutter.unstable.size(), 1u);
  EXPECT_NEAR(flutter.unstable[0].growth_rate, std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(flutter.unstable[0].omega, 0.5, 1e-14);

  const ModesResult stabilised = in_window(pair(-1, -4, 5), 100, 200);  // g > 1 + 2
  EXPECT_EQ(stabilised.stability, Stability::gyroscopically_stabilised);
  EXPECT_EQ(stabilised.modes.size(), 0u);
  ASSERT_EQ(stabilised.negative_modes.size(), 1u);
  EXPECT_EQ(stabilised.negative_modes[0].energy_sign, -1);
}

TEST(Result, FirstOrderConstantSolutionsAreRigid) {
  Matrix g = Matrix::Zero(3, 3);
  g << 0, 1, 2, -1, 0, 2, -2, -2, 0;
  const ModesResult r = find_modes(FirstOrderSystem(Matrix::Identity(3, 3), g));
  ASSERT_EQ(r.modes.size(), 2u);
  EXPECT_TRUE(r.first_order);
  EXPECT_EQ(r.modes[0].kind, ModeKind::rigid_body);
  EXPECT_EQ(r.modes[0].energy_sign, 0);
  EXPECT_NEAR(r.modes[1].omega, 3, 1e-14);
  EXPECT_EQ(r.coverage.status, CoverageStatus::complete);
}

// ---- interrupts

// Of uncoupled oscillators, each a component: those solved when work was stopped are there, and nothing is claimed of
// the whole.
TEST(Result, StoppedBetweenComponents) {
  ModesOptions options;
  Index solved = 0;
  options.progress.tell = [&](std::string_view what, Index done, Index all) {
    if (all == 0) return;  // a stage
    EXPECT_EQ(what, "components");
    EXPECT_EQ(all, 5);
    solved = done;
  };
  options.progress.stop = [&] { return solved >= 2; };
  const ModesResult r = find_modes(ladder(), options);
  EXPECT_EQ(r.modes.size(), 2u);
  EXPECT_TRUE(r.coverage.interrupted);
  EXPECT_EQ(r.coverage.status, CoverageStatus::not_counted);
  EXPECT_EQ(r.coverage.reason, "interrupted: 2 of 5 components were solved");
  EXPECT_EQ(r.stability, Stability::unknown);
  EXPECT_FALSE(r.index_balance.closed);
  options.progress.stop = [] { return true; };
  EXPECT_THROW(find_modes(ladder(), options), Interrupted);
}

// ---- refusals

std::string refusal(const System& s, Method method) {
  ModesOptions options;
  options.method = method;
  try {
    find_modes(s, options);
  } catch (const NotApplicable& e) {
    return e.what();
  }
  return "";
}

TEST(Methods, AreRefusedWhereTheyDoNotApply) {
  const std::string no_partition = refusal(triangle(1), Method::quadrature);
  EXPECT_NE(no_partition.find("needs a quadrature partition"), std::string::npos) << no_partition;
  EXPECT_NE(no_partition.find("'q1'"), std::string::npos) << no_partition;
  EXPECT_NE(refusal(triangle(-1), Method::meirovitch).find("K has 1 negative and 0 zero eigenvalues"), std::string::npos);
  EXPECT_NE(refusal(triangle(0), Method::meirovitch).find("K has 0 negative and 1 zero eigenvalues"), std::string::npos);
  for (const auto method : {Method::automatic, Method::general, Method::companion, Method::meirovitch}) {
    EXPECT_EQ(refusal(triangle(1), method), "");
    EXPECT_EQ(refusal(pair(1, 2, 1), method), "");
  }
  EXPECT_EQ(refusal(pair(-1, -2, 1), Method::quadrature), "");
  ModesOptions options;
  options.method = Method::companion;
  Matrix g = Matrix::Zero(2, 2);
  g << 0, 1, -1, 0;
  EXPECT_THROW(find_modes(FirstOrderSystem(Matrix::Identity(2, 2), g), options), NotApplicable);
}

}  // namespace
}  // namespace gyromode
