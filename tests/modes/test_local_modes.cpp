// Local modes with known truth: equal appendages on a body, appendages that nothing couples to it, in any internal
// coordinates and units. Of c copies with the same attachment, c − 1 combinations of each of their modes leave the body
// at rest; with different attachments to a body of b coordinates, c − b; without any, all c.
#include "gyromode/modes/keep.h"

#include "support/random_matrices.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace gyromode {
namespace {

std::vector<Mode> locals(const ModesResult& r) {
  std::vector<Mode> found;
  std::copy_if(r.modes.begin(), r.modes.end(), std::back_inserter(found), [](const Mode& m) { return m.kind == ModeKind::local; });
  return found;
}

std::vector<double> frequencies(const std::vector<Mode>& modes) {
  std::vector<double> omega;
  for (const Mode& m : modes) omega.push_back(m.omega);
  return omega;
}

Index how_many(const Matrix& m, const Matrix& g, const Matrix& k, std::vector<Index> kept = {0}) {
  return static_cast<Index>(locals(find_modes_keeping(System(m, g, k), kept, {})).size());
}

Matrix no_gyroscopic(Index n) { return Matrix::Zero(n, n); }
Matrix skew2(double g) { return Matrix{{0, -g}, {g, 0}}; }

Matrix beside(const Matrix& a, const Matrix& b) {
  Matrix c = Matrix::Zero(a.rows() + b.rows(), a.cols() + b.cols());
  c.topLeftCorner(a.rows(), a.cols()) = a;
  c.bottomRightCorner(b.rows(), b.cols()) = b;
  return c;
}

TEST(LocalModes, OfTwoEqualAppendagesOneMoves) {
  const Matrix m = Vector{{2, 0.7, 0.7}}.asDiagonal();
  const Matrix k = Matrix{{5, -1, -1}, {-1, 3, 0}, {-1, 0, 3}};
  ModesOptions options;
  options.shapes = true;
  const std::vector<Mode> found = locals(find_modes_keeping(System(m, no_gyroscopic(3), k), {0}, options));
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].omega, std::sqrt(3 / 0.7), 1e-14);
  EXPECT_EQ(found[0].shape(0), Complex(0));
  EXPECT_NEAR(std::abs(found[0].shape(1) + found[0].shape(2)), 0, 1e-14);
}

// The root of q3 has the frequency of one of opposite energy in another component: a component is local by itself.
TEST(LocalModes, AComponentWithoutKeptCoordinatesIsLocal) {
  const Matrix k = Vector{{-15, -15, 9}}.asDiagonal();
  const ModesResult r = find_modes_keeping(System(Matrix::Identity(3, 3), beside(skew2(8), no_gyroscopic(1)), k), {0}, {});
  ASSERT_EQ(locals(r).size(), 1u);
  EXPECT_EQ(locals(r)[0].omega, 3);
  EXPECT_EQ(locals(r)[0].energy_sign, 1);
  EXPECT_EQ(how_many(Matrix::Identity(3, 3), beside(skew2(8), no_gyroscopic(1)), k, {2}), 2);
  EXPECT_EQ(how_many(Matrix::Identity(3, 3), beside(skew2(8), no_gyroscopic(1)), k, {0, 1, 2}), 0);
}

// However weak the coupling: the mode moves q1, and says so.
TEST(LocalModes, AWeakCouplingIsACoupling) {
  for (const double weak : {3e-7, 1e-9, 1e-11, 1e-13, 1e-20, 1e-100}) {
    for (const double unit : {0x1p-30, 1.0, 0x1p30}) {
      const Matrix k = Matrix{{1, weak * unit}, {weak * unit, 4 * unit * unit}};
      const Matrix m = Vector{{1, unit * unit}}.asDiagonal();
      ModesOptions options;
      options.shapes = true;
      const ModesResult r = find_modes_keeping(System(m, no_gyroscopic(2), k), {0}, options);
      EXPECT_TRUE(locals(r).empty()) << weak << " in units " << unit;
      EXPECT_NE(r.modes[1].shape(0), Complex(0)) << weak;
    }
    EXPECT_EQ(how_many(Matrix::Identity(2, 2), skew2(weak), Vector{{1, 4}}.asDiagonal()), 0) << weak;
  }
}

// Appendages that differ by a little are two different ones, and both move the body.
TEST(LocalModes, DetunedAppendagesAreNotEqual) {
  for (const double detuning : {1e-3, 1e-6, 1e-9, 1e-12}) {
    Matrix k{{5, -1, -1}, {-1, 3, 0}, {-1, 0, 3}};
    k(1, 1) *= 1 + detuning;
    EXPECT_EQ(how_many(Vector{{2, 0.7, 0.7}}.asDiagonal(), no_gyroscopic(3), k), 0) << detuning;
  }
}

struct Known {
  Matrix m, g, k;
  Index body;
  std::vector<double> local;  // ascending
  std::string what;
};

struct Appendage {
  Matrix m, g, k;
  std::vector<double> omega;  // its own modes, the body held
};

// Of 1 to 3 coordinates; stiff, or soft and held by gyroscopic forces. Those near flutter are drawn again.
Appendage random_appendage(support::Source& s, Index grading) {
  while (true) {
    const Index n = s.integer(1, 3);
    Appendage a{s.symmetric(n, 0), s.skew(n), s.symmetric(n, 0) * std::exp2(static_cast<double>(s.integer(-grading, grading))), {}};
    const Index gyroscopic = s.integer(0, 2);
    a.g *= gyroscopic == 0 ? 0 : gyroscopic == 1 ? 1 : 8;
    if (n > 1 && gyroscopic == 2 && s.integer(0, 1) == 0) a.k = -a.k;
    const ModesResult r = find_modes(System(a.m, a.g, a.k));
    bool clear = r.coverage.status == CoverageStatus::complete && r.stability != Stability::marginal;
    for (const UnstableMode& u : r.unstable) clear = clear && !u.flutter();
    for (const Mode& m : r.modes) {
      clear = clear && m.kind == ModeKind::vibration && m.omega > 0 && m.error_bound <= 1e-11 * m.omega;
      a.omega.push_back(m.omega);
    }
    if (clear && r.opposite_gap > 1e-3) return a;
  }
}

enum class Attachment { same, different, none };

void attach(Known& x, const Appendage& a, Index copies, Attachment how, support::Source& s) {
  const Index n = a.m.rows();
  Matrix on_k = s.gaussian(x.body, n), on_g = s.gaussian(x.body, n), on_m = 0.02 * s.gaussian(x.body, n);
  const bool by_spring_alone = s.integer(0, 1) == 0;
  for (Index c = 0; c < copies; ++c) {
    if (how == Attachment::different) on_k = s.gaussian(x.body, n);
    const Index first = x.m.rows();
    x.m = beside(x.m, a.m);
    x.g = beside(x.g, a.g);
    x.k = beside(x.k, a.k);
    if (how == Attachment::none) continue;
    x.k.block(0, first, x.body, n) = on_k;
    x.k.block(first, 0, n, x.body) = on_k.transpose();
    if (by_spring_alone || how == Attachment::different) continue;
    x.g.block(0, first, x.body, n) = on_g;
    x.g.block(first, 0, n, x.body) = -on_g.transpose();
    x.m.block(0, first, x.body, n) = on_m;
    x.m.block(first, 0, n, x.body) = on_m.transpose();
  }
  const Index resting = how == Attachment::none ? copies : how == Attachment::same ? copies - 1 : std::max<Index>(0, copies - x.body);
  for (const double w : a.omega) x.local.insert(x.local.end(), static_cast<std::size_t>(resting), w);
  x.what += fmt::format(" {}x{}{}", copies, n, how == Attachment::none ? "free" : how == Attachment::same ? "same" : "different");
}

// Other internal coordinates, other units for every coordinate, of time and of mass.
void change_coordinates(Known& x, bool mixed, support::Source& s) {
  const Index n = x.m.rows(), inside = n - x.body;
  const auto congruent = [&](const Matrix& t) {
    for (Matrix* a : {&x.m, &x.g, &x.k}) *a = (t.transpose() * *a * t).eval();
    x.m = symmetric_part(x.m);
    x.g = skew_part(x.g);
    x.k = symmetric_part(x.k);
  };
  if (mixed) {
    congruent(beside(Matrix::Identity(x.body, x.body), s.orthogonal(inside)));
    x.what += " mixed";
  }
  if (s.integer(0, 1) == 0) {
    Vector d(n);
    for (double& v : d) v = std::exp2(static_cast<double>(s.integer(-30, 30)));
    congruent(d.asDiagonal());
    x.what += " units";
  }
  const double time = std::exp2(static_cast<double>(30 * s.integer(-1, 1))), mass = std::exp2(static_cast<double>(30 * s.integer(-1, 1)));
  x.m *= mass;
  x.g *= mass * time;
  x.k *= mass * time * time;
  for (double& w : x.local) w *= time;
}

Known random_known(std::uint64_t seed) {
  support::Source s{std::mt19937_64(seed)};
  Known x;
  const bool mixed = s.integer(0, 1) == 0;  // other coordinates round at the size of the stiffest appendage
  const Index grading = mixed ? 3 : 12;
  x.body = s.integer(1, 3);
  x.m = 4 * s.symmetric(x.body, 0);
  x.g = static_cast<double>(s.integer(0, 1)) * s.skew(x.body);
  x.k = s.symmetric(x.body, s.integer(0, 1)) * 8;
  for (Index types = s.integer(1, 3); types > 0; --types) {
    const Attachment how =
        std::array{Attachment::same, Attachment::same, Attachment::different, Attachment::none}[static_cast<std::size_t>(s.integer(0, 3))];
    attach(x, random_appendage(s, grading), s.integer(1, 4), how, s);
  }
  std::sort(x.local.begin(), x.local.end());
  change_coordinates(x, mixed, s);
  return x;
}

TEST(LocalModes, OfRandomAppendagesAreThoseThatMechanicsGives) {
  std::size_t with_locals = 0, unsolved = 0;
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    const Known x = random_known(seed);
    const System system(x.m, x.g, x.k);
    std::vector<Index> kept(static_cast<std::size_t>(x.body));
    std::iota(kept.begin(), kept.end(), Index{0});
    ModesOptions options;
    options.shapes = true;
    const ModesResult r = find_modes_keeping(system, kept, options);
    const bool undecided =
        std::any_of(r.modes.begin(), r.modes.end(), [](const Mode& m) { return m.kind != ModeKind::rigid_body && m.energy_sign == 0; });
    if (undecided || r.coverage.status != CoverageStatus::complete) {
      ++unsolved;
      continue;
    }
    const std::vector<Mode> found = locals(r);
    const std::vector<double> omega = frequencies(found);
    with_locals += x.local.empty() ? 0 : 1;
    const bool right = omega.size() == x.local.size() && std::equal(omega.begin(), omega.end(), x.local.begin(),
                                                                    [](double a, double b) { return std::abs(a - b) <= 1e-9 * b; });
    EXPECT_TRUE(right) << "seed " << seed << ":" << x.what << ", n = " << system.size() << ", " << to_string(r.coverage.status)
                       << ", local: " << fmt::format("{}", fmt::join(omega, " "))
                       << "; truth: " << fmt::format("{}", fmt::join(x.local, " "));
    for (const Mode& m : found) EXPECT_TRUE((m.shape(kept).array() == Complex(0)).all()) << seed;
  }
  EXPECT_GE(with_locals, 1000u);
  EXPECT_LE(unsolved, 75u) << "of these the modes themselves are not all known";
}

}  // namespace
}  // namespace gyromode
