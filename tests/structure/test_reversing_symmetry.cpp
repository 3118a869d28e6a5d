#include "gyromode/base/error.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"
#include "gyromode/modes/modes.h"
#include "gyromode/structure/reversing_symmetry.h"
#include "gyromode/structure/symmetry_words.h"
#include "gyromode/system/laws.h"
#include "support/random_matrices.h"
#include "support/scrambled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

using namespace gyromode;
using support::Scrambled;
using support::scrambled_system;

namespace {

// How many: GYROMODE_SCRAMBLED, or few.
std::uint64_t seeds() {
  const char* asked = std::getenv("GYROMODE_SCRAMBLED");
  return asked ? std::strtoull(asked, nullptr, 10) : 200;
}

// Every tenth is large, so that 10⁴ of them take minutes and not an hour.
Index order_of(std::uint64_t seed) { return seed % 10 == 0 ? 200 : 40; }

SymmetrySearch search(const System& s) { return find_reversing_symmetry(s.mass(), s.gyroscopic(), s.stiffness()); }

ModesOptions by(Method method) {
  ModesOptions options;
  options.method = method;
  return options;
}

}  // namespace

// The symmetry found is one of the matrices as given: (T7) with R of norm up to the condition of S.
TEST(ReversingSymmetry, ScrambledSystemsAreRecognised) {
  for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
    const Scrambled s = scrambled_system(seed, order_of(seed), 1e6);
    const SymmetrySearch f = search(s.hidden);
    ASSERT_TRUE(f.found) << seed << ": " << s.description << ", condition " << s.condition << ", departure " << f.departure << " of "
                         << f.threshold;
    const Matrix r = f.found->reflection(s.hidden.mass());
    const double eps = std::numeric_limits<double>::epsilon(), n = static_cast<double>(s.hidden.size());
    // ‖R‖ is up to the condition of S, and M is formed with errors of ε‖M‖.
    const double rounding = 100 * n * eps * s.condition * s.condition * s.condition;
    EXPECT_LE((r * r - Matrix::Identity(r.rows(), r.rows())).norm(), rounding * r.norm()) << seed;
  }
}

TEST(ReversingSymmetry, FrequenciesOfScrambledSystems) {
  for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
    const Scrambled s = scrambled_system(seed, order_of(seed) / 4, 1e6);
    const ModesResult plain = find_modes(s.plain), hidden = find_modes(s.hidden, by(Method::hidden));
    ASSERT_EQ(plain.structure.system_class(), SystemClass::quadrature);
    EXPECT_EQ(hidden.structure.system_class(), SystemClass::hidden_quadrature) << seed;
    const double cond = s.condition * s.condition;  // of M: what rounding in the scrambled matrices is multiplied by
    std::vector<double> expected, found;
    for (const Mode& m : plain.modes) expected.push_back(m.omega);
    for (const Mode& m : hidden.modes) found.push_back(m.omega);
    if (s.condition < 1e3) {
      ASSERT_EQ(found.size(), expected.size()) << seed << ": " << s.description;
      EXPECT_EQ(to_string(hidden.stability), to_string(plain.stability)) << seed << ": " << s.description << " " << s.condition;
    }
    if (found.size() != expected.size()) continue;  // an ω of an indefinite K within rounding · cond of the axis
    const double largest = expected.empty() ? 0 : expected.back();
    for (std::size_t k = 0; k < expected.size(); ++k) {
      EXPECT_LE(std::abs(found[k] - expected[k]), std::max(1e-10 * s.condition, 1e-15 * cond) * largest)
          << seed << ": " << s.description << ", condition " << s.condition;
    }
  }
}

// 1e-6 of G is far more than rounding. Where (K, M) has repeated eigenvalues and n is small, the perturbed system may
// have a symmetry of its own: then it is exact.
TEST(ReversingSymmetry, PerturbedSystemsAreNot) {
  for (std::uint64_t seed = 0; seed < seeds(); ++seed) {
    const Scrambled s = scrambled_system(seed, order_of(seed), 1e3);
    const SymmetrySearch f = search(support::with_perturbed_gyroscopic(s.hidden, 1e-6, seed));
    if (s.repeated && f.found) {
      EXPECT_LE(f.departure, 1e-9) << seed << ": " << s.description;
      continue;
    }
    EXPECT_FALSE(f.found) << seed << ": " << s.description << ", condition " << s.condition << ", departure " << f.departure << " of "
                          << f.threshold;
    EXPECT_GE(f.departure, 100 * f.threshold) << seed;
  }
}

// A rotor with unequal supports in axes turned by 20° from them, node by node.
TEST(ReversingSymmetry, MirrorInWords) {
  const double phi = 20 * M_PI / 180;
  Matrix turn(4, 4);
  turn.setZero();
  turn.topLeftCorner(2, 2) << std::cos(phi), -std::sin(phi), std::sin(phi), std::cos(phi);
  turn.bottomRightCorner(2, 2) = turn.topLeftCorner(2, 2);
  Matrix k(4, 4), g(4, 4);
  k << 5, 0, -2, 0, 0, 7, 0, -2, -2, 0, 3, 0, 0, -2, 0, 4;
  g << 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 0, -2, 0, 0, 2, 0;
  const System s(Matrix::Identity(4, 4), skew_part(turn.transpose() * g * turn), symmetric_part(turn.transpose() * k * turn),
                 {"x1", "y1", "x2", "y2"});
  const SymmetrySearch f = search(s);
  ASSERT_TRUE(f.found);
  EXPECT_LE(f.departure, 1e-14);
  const std::string words = in_words(f.found->reflection(s.mass()), s.labels());
  EXPECT_TRUE(words == "a mirror or half-turn along the line at -20° in the planes (x1, y1), (x2, y2): 2 in phase, 2 in quadrature" ||
              words == "a mirror or half-turn along the line at 70° in the planes (x1, y1), (x2, y2): 2 in phase, 2 in quadrature")
      << words;
}

// Two equal blades that the mirror exchanges, and a hub coordinate that it reverses.
TEST(ReversingSymmetry, ExchangeInWords) {
  Matrix r = Matrix::Zero(4, 4);
  r(0, 1) = r(1, 0) = 1;
  r(2, 2) = -1;
  r(3, 3) = 1;
  EXPECT_EQ(in_words(r, {"a", "b", "h", "z"}),
            "a mirror or half-turn that exchanges a ↔ b, reverses h, keeps z: 2 in phase, 2 in quadrature");
  Matrix mixed = Matrix::Identity(3, 3) - 2.0 / 3.0 * Matrix::Ones(3, 3);
  EXPECT_EQ(in_words(mixed, {"a", "b", "c"}), "a reflection that mixes the coordinates: 2 in phase, 1 in quadrature");
}

TEST(ReversingSymmetry, UnitsDoNotMatter) {
  const Scrambled s = scrambled_system(4, 12, 100);
  const SymmetrySearch one = search(s.hidden);
  for (const double unit : {1e-9, 1e9}) {
    const SymmetrySearch f = find_reversing_symmetry(unit * s.hidden.mass(), unit * s.hidden.gyroscopic(), unit * s.hidden.stiffness());
    ASSERT_TRUE(f.found);
    EXPECT_NEAR(std::log(f.threshold / one.threshold), 0, 0.5);  // of K or of G, whichever is nearer to its limit
    const SymmetrySearch slow = find_reversing_symmetry(s.hidden.mass(), unit * s.hidden.gyroscopic(), unit * unit * s.hidden.stiffness());
    ASSERT_TRUE(slow.found);
    EXPECT_NEAR(std::log(slow.threshold / one.threshold), 0, 0.5);
  }
}

TEST(ReversingSymmetry, SingularAndIndefiniteStiffness) {
  support::Source s{std::mt19937_64(5)};
  for (int trial = 0; trial < 50; ++trial) {
    const Index p = s.integer(2, 5), r = s.integer(2, 5), n = p + r;
    Matrix k = Matrix::Zero(n, n), g = Matrix::Zero(n, n);
    Matrix k1 = s.symmetric(p, trial % 3), k2 = s.symmetric(r, trial % 2);
    const Vector u = s.gaussian(p, 1).normalized();
    k1 = ((Matrix::Identity(p, p) - u * u.transpose()) * k1 * (Matrix::Identity(p, p) - u * u.transpose())).eval();
    k.topLeftCorner(p, p) = k1;
    k.bottomRightCorner(r, r) = k2;
    const Matrix b = s.gaussian(p, r);
    g.topRightCorner(p, r) = b;
    g.bottomLeftCorner(r, p) = -b.transpose();
    const Matrix t = s.orthogonal(n);
    const System plain(Matrix::Identity(n, n), g, symmetric_part(k));
    const System hidden(Matrix::Identity(n, n), skew_part(t.transpose() * g * t), symmetric_part(t.transpose() * k * t));
    const ModesResult a = find_modes(plain), b2 = find_modes(hidden, by(Method::hidden)), c = find_modes(hidden, by(Method::general));
    ASSERT_EQ(a.modes.size(), b2.modes.size()) << trial;
    EXPECT_EQ(to_string(a.stability), to_string(b2.stability)) << trial;
    EXPECT_EQ(to_string(b2.coverage.status), "complete") << trial << " " << b2.coverage.reason;
    EXPECT_EQ(b2.index_balance.zero, c.index_balance.zero) << trial;
    EXPECT_EQ(b2.unstable.size(), c.unstable.size()) << trial;
    for (std::size_t i = 0; i < a.modes.size(); ++i)
      EXPECT_NEAR(a.modes[i].omega, b2.modes[i].omega, 1e-12 * a.modes.back().omega) << trial;
  }
}

// One stiff coordinate makes the rest of K vanish beside it: no symmetry of G alone may pass for one of the system.
TEST(ReversingSymmetry, GradedStiffnessHidesNothing) {
  support::Source s{std::mt19937_64(11)};
  for (const Index n : {6, 20, 60}) {
    for (const double stiff : {1e3, 1e9, 1e12, 1e13, 1e14, 1e15}) {
      const Matrix root = s.gaussian(n, n);
      Matrix k = root * root.transpose() / static_cast<double>(n) + Matrix::Identity(n, n);
      k(n - 1, n - 1) = stiff;
      const SymmetrySearch f = find_reversing_symmetry(Matrix::Identity(n, n), s.skew(n), symmetric_part(k));
      EXPECT_FALSE(f.found) << n << " " << stiff << ": departure " << f.departure << " of " << f.threshold;
    }
  }
}

// A scrambled system with all its frequencies certified: residuals, counts and balance are those of the matrices as
// given. A clamped chain that bends in two directions, in axes that turn `spin` times as fast as its slowest mode:
// eigenvalues of K over eight decades, every pair of modes a symmetry of its own. In orthogonal coordinates that hide
// it.
TEST(ReversingSymmetry, SpinningBeams) {
  support::Source source{std::mt19937_64(23)};
  for (const Index m : {4, 20, 60, 120}) {
    Matrix d = Matrix::Identity(m, m);
    for (Index i = 1; i < m; ++i) {
      d(i, i - 1) = -2;
      if (i > 1) d(i, i - 2) = 1;
    }
    const Matrix bending = d.transpose() * d;
    const double slowest = small::symmetric_eigenvalues(bending)(0);
    for (const double spin : {0.5, 10.0, 300.0}) {
      const double spin2 = spin * spin * slowest;
      const Matrix t = source.orthogonal(2 * m);
      Matrix k = Matrix::Zero(2 * m, 2 * m), g = Matrix::Zero(2 * m, 2 * m);
      k.topLeftCorner(m, m) = bending - spin2 * Matrix::Identity(m, m);
      k.bottomRightCorner(m, m) = 1.5 * bending - spin2 * Matrix::Identity(m, m);
      g.bottomLeftCorner(m, m) = 2 * std::sqrt(spin2) * Matrix::Identity(m, m);
      g.topRightCorner(m, m) = -g.bottomLeftCorner(m, m);
      const System s(Matrix::Identity(2 * m, 2 * m), skew_part(t * g * t.transpose()), symmetric_part(t * k * t.transpose()));
      const SymmetrySearch f = search(s);
      EXPECT_TRUE(f.found) << m << " " << spin << ", departure " << f.departure << " of " << f.threshold;
    }
  }
}

TEST(ReversingSymmetry, ScrambledSystemsAreCertified) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scrambled s = scrambled_system(seed, 24, 1e6);
    const ModesResult r = find_modes(s.hidden);
    EXPECT_EQ(to_string(r.coverage.status), "complete") << seed << ": " << s.description << ", " << r.coverage.reason;
  }
}

TEST(ReversingSymmetry, MethodRefusedWithTheMiss) {
  support::Source s{std::mt19937_64(3)};
  const System general(Matrix::Identity(5, 5), s.skew(5), s.symmetric(5, 0));
  try {
    find_modes(general, by(Method::hidden));
    FAIL();
  } catch (const NotApplicable& e) {
    EXPECT_NE(std::string(e.what()).find("the nearest reflection breaks the commutation rules by 0."), std::string::npos) << e.what();
  }
}
