// Mass-normal coordinates: identities of the congruences.
#include "support/random_matrices.h"
#include "gyromode/base/rounding.h"
#include "gyromode/dense/mass_normal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::dense {
namespace {

using support::Source;

TEST(MassNormal, Identities) {
  Source source{std::mt19937_64(14)};
  for (const Index n : {1, 2, 7, 40}) {
    const double unit = 50 * static_cast<double>(n) * epsilon;
    const Matrix m = source.symmetric(n, 0);
    const Matrix k = source.symmetric(n, 0);
    const Matrix g = source.skew(n);
    const Matrix b = source.gaussian(n, n + 1);
    const MassNormal normal(m);
    const MassNormal other(source.symmetric(n + 1, 0));
    Matrix phi = Matrix::Identity(n, n);
    normal.to_physical(phi);
    Matrix psi = Matrix::Identity(n + 1, n + 1);
    other.to_physical(psi);
    EXPECT_LE((phi.transpose() * m * phi - Matrix::Identity(n, n)).norm(), unit);
    EXPECT_LE((normal.stiffness(k) - phi.transpose() * k * phi).norm(), unit * k.norm());
    EXPECT_LE((normal.gyroscopic(g) - phi.transpose() * g * phi).norm(), unit * g.norm());
    EXPECT_LE((normal.coupling(b, other) - phi.transpose() * b * psi).norm(), unit * b.norm());
    const Matrix f = normal.stiffness_root(*StiffnessFactor::of(k, inertia_of_k(k)));
    EXPECT_LE((f * f.transpose() - normal.stiffness(k)).norm(), unit * k.norm());
    EXPECT_TRUE(f.isLowerTriangular(0));
    EXPECT_EQ(normal.stiffness(k), normal.stiffness(k).transpose());
    EXPECT_EQ(normal.gyroscopic(g), -normal.gyroscopic(g).transpose());
    Matrix back = phi;
    normal.to_normal(back);
    EXPECT_LE((back - Matrix::Identity(n, n)).norm(), unit);

    // Units of coordinates by powers of two cost not a bit.
    Vector d(n);
    for (Index i = 0; i < n; ++i) d(i) = std::ldexp(1.0, static_cast<int>(source.integer(-40, 40)));
    const MassNormal mixed(d.asDiagonal() * m * d.asDiagonal());
    const Matrix scaled = d.asDiagonal() * k * d.asDiagonal();
    EXPECT_EQ(mixed.stiffness(scaled), normal.stiffness(k));
    EXPECT_EQ(mixed.stiffness_root(*StiffnessFactor::of(scaled, inertia_of_k(scaled))), f);
  }
}

}  // namespace
}  // namespace gyromode::dense
