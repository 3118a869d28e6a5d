// Partition and components against brute force over all 2ⁿ colourings, witnesses walked step by step; definiteness
// against congruences of integer matrices, whose inertia is known and whose singularity is exact.

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"
#include "gyromode/lapack/small.h"
#include "gyromode/structure/ignored_couplings.h"
#include "gyromode/structure/structure.h"
#include "gyromode/structure/inertia_of_k.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <string>
#include <vector>

namespace gyromode {
namespace {

using Random = std::mt19937_64;
using Places = std::vector<Index>;
using enum CouplingKind;
constexpr double unit_scales[] = {1e-9, 1, 1e9};

struct Link {
  Index i, j;
  char matrix;  // M, K or G
  double value = 1;
};

// A system with the links given; diagonals make M positive definite and are the largest entries of M and K.
System linked(Index n, const std::vector<Link>& links, double unit = 1) {
  Matrix m = static_cast<double>(2 * n) * Matrix::Identity(n, n), k = m, g = Matrix::Zero(n, n);
  for (const auto& [i, j, matrix, value] : links) {
    Matrix& a = matrix == 'M' ? m : matrix == 'K' ? k : g;
    a(i, j) = value;
    a(j, i) = matrix == 'G' ? -value : value;
  }
  return System(unit * m, unit * g, unit * k);
}

std::vector<Link> random_links(Index n, double density, Random& random) {
  std::vector<Link> links;
  for (Index j = 0; j < n; ++j) {
    for (Index i = j + 1; i < n; ++i) {
      for (const char matrix : {'M', 'K', 'G'}) {
        if (std::bernoulli_distribution(density)(random))
          links.push_back({i, j, matrix, std::bernoulli_distribution()(random) ? 1.0 : -1.0});
      }
    }
  }
  return links;
}

bool coupled(const System& s, Index i, Index j, CouplingKind kind) {
  return kind == cross ? s.gyroscopic()(i, j) != 0 : s.mass()(i, j) != 0 || s.stiffness()(i, j) != 0;
}

// A bit a coordinate of `members`: does this colouring keep every parity?
bool colours(const System& s, const Places& members, std::uint64_t colouring) {
  for (const Index i : members) {
    for (const Index j : members) {
      if (i == j) continue;
      const bool differ = ((colouring >> i) ^ (colouring >> j)) & 1;
      if (coupled(s, i, j, differ ? in_phase : cross)) return false;
    }
  }
  return true;
}

void expect_odd_closed_walk(const System& s, const OddCycle& cycle) {
  const std::size_t length = cycle.coordinates.size();
  ASSERT_EQ(cycle.kinds.size(), length);
  ASSERT_GE(length, 2u);
  for (std::size_t k = 0; k < length; ++k) {
    const Index from = cycle.coordinates[k], to = cycle.coordinates[(k + 1) % length];
    EXPECT_NE(from, to);
    EXPECT_TRUE(coupled(s, from, to, cycle.kinds[k])) << from << " → " << to;
  }
  EXPECT_EQ(std::count(cycle.kinds.begin(), cycle.kinds.end(), cross) % 2, 1);
}

TEST(Partition, HandMadeGraphs) {
  const Structure alone = analyse(linked(1, {}));
  ASSERT_EQ(alone.components.size(), 1u);
  EXPECT_TRUE(alone.components[0].in_phase == Places{0} && alone.components[0].in_quadrature.empty());

  const Structure square = analyse(linked(4, {{0, 2, 'G'}, {2, 3, 'K'}, {3, 1, 'G'}, {1, 0, 'M'}}));
  ASSERT_EQ(square.components.size(), 1u);
  EXPECT_EQ(square.components[0].in_phase, (Places{0, 1}));
  EXPECT_EQ(square.components[0].in_quadrature, (Places{2, 3}));
  EXPECT_EQ(square.system_class(), SystemClass::quadrature);

  const System ring = linked(4, {{1, 2, 'G'}, {2, 3, 'G'}, {3, 1, 'G'}});
  const Structure triangle = analyse(ring, HiddenSearch::never);
  EXPECT_EQ(analyse(ring).system_class(), SystemClass::hidden_quadrature);  // M and K are 1: every skew G has a basis of two groups
  ASSERT_EQ(triangle.components.size(), 2u);
  EXPECT_TRUE(triangle.components[0].quadrature() && !triangle.components[1].quadrature());
  EXPECT_EQ(triangle.components[1].coordinates, (Places{1, 2, 3}));
  EXPECT_TRUE(triangle.components[1].in_phase.empty() && triangle.components[1].in_quadrature.empty());
  EXPECT_EQ(triangle.system_class(), SystemClass::general);
  EXPECT_EQ(triangle.witness()->kinds, (std::vector{cross, cross, cross}));
  EXPECT_EQ(triangle.in_phase(), Places{0});

  const Structure nested = analyse(linked(4, {{0, 3, 'K'}, {1, 2, 'G'}}));  // one component inside the other's range
  EXPECT_EQ(nested.in_phase(), (Places{0, 1, 3}));
  EXPECT_EQ(nested.in_quadrature(), Places{2});

  const System both = linked(2, {{0, 1, 'K'}, {0, 1, 'G'}});  // one pair coupled both ways: a walk of two steps
  const auto walk = analyse(both).witness();
  ASSERT_TRUE(walk);
  EXPECT_EQ(walk->coordinates.size(), 2u);
  expect_odd_closed_walk(both, *walk);

  const FirstOrderSystem first(Matrix{{2, 0, 1}, {0, 2, 0}, {1, 0, 2}}, Matrix{{0, 1, 0}, {-1, 0, 3}, {0, -3, 0}});
  EXPECT_EQ(analyse(first).in_phase(), (Places{0, 2}));
  EXPECT_EQ(analyse(first).in_quadrature(), Places{1});
}

TEST(Partition, RandomSystemsAgreeWithBruteForce) {
  Random random(31);
  int general = 0, several = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Index n = 1 + trial % 8;
    const System s = linked(n, random_links(n, 0.3 * (trial % 5) / static_cast<double>(n), random));
    const Structure found = analyse(s);
    // Connected: (1 + A)ⁿ has an entry.
    Matrix reach = Matrix::Identity(n, n) + s.mass().cwiseAbs() + s.stiffness().cwiseAbs() + s.gyroscopic().cwiseAbs(), connected = reach;
    for (Index k = 0; k < n; ++k) connected = (connected * reach).cwiseMin(1);
    Places seen;
    for (const Component& c : found.components) {
      ASSERT_TRUE(std::is_sorted(c.coordinates.begin(), c.coordinates.end()) && !c.coordinates.empty());
      seen.insert(seen.end(), c.coordinates.begin(), c.coordinates.end());
      EXPECT_EQ((connected.col(c.coordinates[0]).array() > 0).count(), static_cast<Index>(c.coordinates.size()));
      for (const Index i : c.coordinates) EXPECT_GT(connected(i, c.coordinates[0]), 0);
      bool exists = false;
      for (std::uint64_t colouring = 0; colouring < (std::uint64_t{1} << n) && !exists; ++colouring)
        exists = colours(s, c.coordinates, colouring);
      ASSERT_EQ(c.quadrature(), exists);
      if (exists) {
        std::uint64_t colouring = 0;
        for (const Index i : c.in_quadrature) colouring |= std::uint64_t{1} << i;
        EXPECT_TRUE(colours(s, c.coordinates, colouring));
        EXPECT_EQ(c.in_phase.front(), c.coordinates.front());
        EXPECT_EQ(c.in_phase.size() + c.in_quadrature.size(), c.coordinates.size());
      } else {
        expect_odd_closed_walk(s, *c.odd_cycle);
        for (const Index i : c.odd_cycle->coordinates) EXPECT_TRUE(std::binary_search(c.coordinates.begin(), c.coordinates.end(), i));
        ++general;
      }
    }
    std::sort(seen.begin(), seen.end());
    Places all(static_cast<std::size_t>(n));
    std::iota(all.begin(), all.end(), Index{0});
    EXPECT_EQ(seen, all);
    several += found.components.size() > 1;
  }
  EXPECT_GT(general, 50);
  EXPECT_GT(several, 100);
}

// Groups laid down first, couplings drawn within the class: what is found is what was laid down, up to a swap in every
// component.
TEST(Partition, ScrambledSystemsOfTheClassAreFound) {
  Random random(32);
  for (int trial = 0; trial < 100; ++trial) {
    const Index n = 1 + trial % 40;
    std::vector<int> group(static_cast<std::size_t>(n));
    for (int& x : group) x = std::bernoulli_distribution(0.4)(random);
    std::vector<Link> links = random_links(n, trial % 2 ? 0.5 : 1 / static_cast<double>(n), random);
    const auto at = [&](Index i) { return group[static_cast<std::size_t>(i)]; };
    std::erase_if(links, [&](const Link& l) { return (l.matrix == 'G') == (at(l.i) == at(l.j)); });
    const Structure found = analyse(linked(n, links));
    ASSERT_EQ(found.system_class(), SystemClass::quadrature);
    EXPECT_FALSE(found.witness());
    for (const Component& c : found.components) {
      for (const Index i : c.in_phase) EXPECT_EQ(at(i), at(c.coordinates.front()));
      for (const Index i : c.in_quadrature) EXPECT_NE(at(i), at(c.coordinates.front()));
    }
    EXPECT_EQ(found.in_phase().size() + found.in_quadrature().size(), static_cast<std::size_t>(n));
  }
}

TEST(Partition, LargeRandomSystemsHaveAWitness) {
  Random random(33);
  for (const Index n : {20, 60, 150}) {
    for (const double density : {2.0, 6.0}) {
      const System s = linked(n, random_links(n, density / static_cast<double>(n), random));
      const auto walk = analyse(s).witness();
      ASSERT_TRUE(walk);
      expect_odd_closed_walk(s, *walk);
    }
  }
}

// Largest entries: 6 in M and K (n = 3), 4 in G. The relative sizes of the weak couplings are 0.001, 0.0001 and 0.01.
TEST(Coupling, ToleranceIsRelativeToEachMatrix) {
  for (const double unit : unit_scales) {
    const System s = linked(3, {{0, 1, 'M', 0.006}, {0, 2, 'K', -0.0006}, {1, 2, 'G', 0.04}, {0, 2, 'G', 4}}, unit);
    const auto at = [&](double tolerance) { return analyse(without_ignored_couplings(s, tolerance)); };
    const auto largest = [&](double tolerance) { return ignored_couplings(s, tolerance).largest; };
    EXPECT_EQ(largest(0), 0);
    EXPECT_EQ(at(0).components[0].quadrature(), false);
    EXPECT_EQ(largest(0.00009), 0);
    EXPECT_NEAR(largest(0.00011), 0.0001, 1e-15);
    EXPECT_EQ(at(0.00011).in_quadrature(), Places{2});
    EXPECT_NEAR(largest(0.0011), 0.001, 1e-15);
    EXPECT_EQ(at(0.0011).in_phase(), (Places{0, 1}));  // 0 –G– 2 –G– 1
    EXPECT_NEAR(largest(0.011), 0.01, 1e-15);
    EXPECT_EQ(at(0.011).components.size(), 2u);
    const System cut = without_ignored_couplings(s, 0.0011);
    EXPECT_TRUE(cut.mass() == Matrix(s.mass().diagonal().asDiagonal()) && cut.stiffness() == Matrix(s.stiffness().diagonal().asDiagonal()));
    EXPECT_TRUE(cut.gyroscopic() == s.gyroscopic() && cut.labels() == s.labels());
    EXPECT_TRUE(without_ignored_couplings(s, 0).mass() == s.mass());
    const FirstOrderSystem f(s.mass(), s.gyroscopic());
    EXPECT_TRUE(without_ignored_couplings(f, 0.011).inertia() == cut.mass());
    EXPECT_EQ(without_ignored_couplings(f, 0.011).gyroscopic()(1, 2), 0);
    EXPECT_NEAR(ignored_couplings(f, 0.011).largest, 0.01, 1e-15);
  }
  // tolerance 0 leaves nothing out
  EXPECT_EQ(analyse(linked(2, {{0, 1, 'K', 1e-300}, {0, 1, 'G'}}), HiddenSearch::never).system_class(), SystemClass::general);
  const System limit = linked(2, {{0, 1, 'G', 6}});  // left out at the limit
  EXPECT_EQ(analyse(without_ignored_couplings(limit, 1)).components.size(), 2u);
  const Matrix light = Eigen::Vector2d(1, 1e-6).asDiagonal();  // a diagonal is no coupling, however small
  EXPECT_TRUE(without_ignored_couplings(System(light, Matrix::Zero(2, 2), light), 0.1).mass() == light);
}

TEST(Coupling, ToleranceIsAFraction) {
  const System s = linked(2, {{0, 1, 'K'}});
  const FirstOrderSystem f(s.mass(), s.gyroscopic());
  for (const double none : {-1e-300, 1.1, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(without_ignored_couplings(s, none), InvalidArgument) << none;
    EXPECT_THROW(without_ignored_couplings(f, none), InvalidArgument) << none;
    EXPECT_THROW(ignored_couplings(s, none), InvalidArgument) << none;
  }
}

// Positive by its smallest coupling alone: det = 0.0455, and −0.28 without it.
TEST(Coupling, MassWithoutThemMustBePositive) {
  const Matrix weak{{1, 0.8, 0.35}, {0.8, 1, 0.8}, {0.35, 0.8, 1}};
  try {
    without_ignored_couplings(System(weak, Matrix::Zero(3, 3), Matrix::Identity(3, 3)), 0.4);
    ADD_FAILURE() << "M without its smallest coupling is indefinite";
  } catch (const LawBroken& e) {
    EXPECT_NE(std::string(e.what()).find("couplings up to 0.4"), std::string::npos) << e.what();
  }
}

// ---- definiteness

// K₀ = SᵀDS, det S = ±1, all integers: n₋, n₀, n₊ are counted on D and null(K₀) = S⁻¹ null(D).
struct Congruence {
  Matrix k;
  Index negative = 0, zero = 0, positive = 0;
  Matrix null_space;
};

Congruence random_congruence(Index n, bool semidefinite, Random& random) {
  std::uniform_int_distribution<int> digit(-1, 1), value(semidefinite ? 0 : -1, 2);
  Matrix l = Matrix::Identity(n, n), u = l;
  Vector d(n);
  for (Index j = 0; j < n; ++j) {
    d(j) = value(random);
    for (Index i = j + 1; i < n; ++i) {
      l(i, j) = digit(random);
      u(j, i) = std::abs(i - j) == 1 ? digit(random) : 0;
    }
  }
  const Matrix s = l * u;
  const Matrix inverse = s.inverse().array().round();
  EXPECT_TRUE(s * inverse == Matrix::Identity(n, n));
  Congruence c{s.transpose() * d.asDiagonal() * s, (d.array() < 0).count(), (d.array() == 0).count(), (d.array() > 0).count(),
               Matrix(n, 0)};
  c.null_space.resize(n, c.zero);
  for (Index j = 0, k = 0; j < n; ++j) {
    if (d(j) == 0) c.null_space.col(k++) = inverse.col(j);
  }
  return c;
}

void expect_counts(const StiffnessInertia& found, const Congruence& truth) {
  EXPECT_EQ(found.negative, truth.negative) << truth.k;
  EXPECT_EQ(found.zero, truth.zero) << truth.k;
  EXPECT_EQ(found.positive, truth.positive) << truth.k;
  EXPECT_EQ(found.definiteness(), truth.negative > 0 ? Definiteness::indefinite
                                  : truth.zero > 0   ? Definiteness::semidefinite
                                                     : Definiteness::positive);
}

TEST(Definiteness, InertiaAndNullSpaceOfCongruencesInAnyUnits) {
  Random random(34);
  std::uniform_real_distribution<double> exponent(-6, 6);
  int null_spaces = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Index n = 1 + trial % 9;
    const Congruence c = random_congruence(n, trial % 3 == 0, random);
    const Vector unequal = Vector::NullaryExpr(n, [&] { return std::pow(10, exponent(random)); });
    for (const double unit : unit_scales) {
      for (const Vector& t : {Vector(Vector::Ones(n)), unequal}) {
        const Matrix k = unit * symmetric_part(t.asDiagonal() * c.k * t.asDiagonal());
        const StiffnessInertia found = inertia_of_k(k);
        expect_counts(found, c);
        ASSERT_EQ(found.null_space.rows(), n);
        ASSERT_EQ(found.null_space.cols(), found.zero);
        const bool free_coordinate = (c.k.cwiseAbs().rowwise().maxCoeff().array() == 0).any();  // a test of its own below
        if (found.zero != c.zero || c.zero == 0 || free_coordinate) continue;
        // T N in equal units lies within span(S⁻¹ null(D)); of full rank where the units were equal from the start.
        const Matrix back = (t.asDiagonal() * found.null_space).colwise().normalized();
        const Matrix q = small::orthogonal_factor(c.null_space).leftCols(c.zero);
        const double gap = c.zero < n ? found.margin : 1;
        EXPECT_LE((back - q * (q.transpose() * back)).norm(), 1e3 * static_cast<double>(n) * epsilon / gap) << k;
        if (t == Vector::Ones(n)) {
          EXPECT_GT(small::singular_values(Matrix(back).cast<Complex>()).minCoeff(), 0.1) << k;
        }
        EXPECT_LE((found.null_space.colwise().norm().array() - 1).abs().maxCoeff(), 4 * epsilon);
        ++null_spaces;
      }
    }
  }
  EXPECT_GT(null_spaces, 600);
}

TEST(Definiteness, EdgeCases) {
  const StiffnessInertia nothing = inertia_of_k(Matrix(0, 0)), zero = inertia_of_k(Matrix::Zero(3, 3));
  EXPECT_TRUE(nothing.negative == 0 && nothing.zero == 0 && nothing.positive == 0 && nothing.definiteness() == Definiteness::positive);
  EXPECT_TRUE(zero.negative == 0 && zero.zero == 3 && zero.positive == 0 && zero.definiteness() == Definiteness::semidefinite);
  EXPECT_NEAR(std::abs(zero.null_space.determinant()), 1, 10 * epsilon);
  for (const double unit : {1e-300, 1e-9, 1.0, 1e9, 1e300}) {
    EXPECT_EQ(inertia_of_k(Matrix{{unit}}).definiteness(), Definiteness::positive);
    EXPECT_EQ(inertia_of_k(Matrix{{-unit}}).definiteness(), Definiteness::indefinite);
    EXPECT_EQ(inertia_of_k(unit * Matrix{{0, 1}, {1, 0}}).negative, 1);
    EXPECT_EQ(inertia_of_k(unit * Matrix{{1, -1}, {-1, 1}}).zero, 1);
    EXPECT_EQ(inertia_of_k(unit * Matrix{{0, 0}, {0, 1}}).zero, 1);
  }
  EXPECT_EQ(inertia_of_k(Matrix{{0}}).definiteness(), Definiteness::semidefinite);
  EXPECT_EQ(std::abs(inertia_of_k(Matrix{{0}}).null_space(0, 0)), 1);
}

// ---- known not to hold yet

TEST(Definiteness, SingularWhereTheConditionEstimateIsBlind) {  // K = FᵀF, F 4 × 5; a pivot of 2e-16, but rcond said 0.01
  const Matrix k{{3, 0, 0, 2, -1}, {0, 3, 2, 2, 2}, {0, 2, 3, 2, 0}, {2, 2, 2, 3, 0}, {-1, 2, 0, 0, 3}};
  EXPECT_EQ(k.fullPivLu().rank(), 4);
  EXPECT_EQ(inertia_of_k(k).zero, 1);
}

TEST(Definiteness, FreeCoordinateIsNullInAnyUnit) {  // its row of zeros keeps d = 1 beside 3e4: the null vector is off by 2e-11
  const StiffnessInertia d = inertia_of_k(1e-9 * Matrix{{2, 0, 1}, {0, 0, 0}, {1, 0, 1}});
  ASSERT_EQ(d.zero, 1);
  EXPECT_LE(std::hypot(d.null_space(0, 0), d.null_space(2, 0)), 100 * epsilon);
}

// Columns of length 1 point the same way once the units differ, unless they are made independent.
TEST(Definiteness, NullSpaceHasFullRankInMixedUnits) {
  const Vector u = Eigen::Vector4d(1, 2, 3, 4), v = Eigen::Vector4d(1, -1, 1, 2), t = Eigen::Vector4d(0x1p-30, 0x1p-10, 0x1p10, 0x1p30);
  const StiffnessInertia d = inertia_of_k(t.asDiagonal() * (u * u.transpose() + v * v.transpose()) * t.asDiagonal());
  ASSERT_EQ(d.zero, 2);
  EXPECT_GT(small::singular_values(Matrix(d.null_space).cast<Complex>())(1), 0.1);
}

}  // namespace
}  // namespace gyromode
