// What matrices that break a law most probably are: sentences that name it, and none that names what is not there.
#include "gyromode/base/error.h"
#include "gyromode/system/system.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace gyromode {
namespace {

std::string said_of(const Matrix& m, const Matrix& g, const Matrix& k) {
  try {
    System(m, g, k);
  } catch (const LawBroken& e) {
    return e.what();
  }
  return "accepted";
}

void expect_said(const Matrix& m, const Matrix& g, const Matrix& k, const std::string& words) {
  const std::string said = said_of(m, g, k);
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

const Matrix one = Matrix::Identity(3, 3);
const Matrix turning{{0, 2, -1}, {-2, 0, 0.5}, {1, -0.5, 0}};
const Matrix springs{{5, 1, 0}, {1, 6, 2}, {0, 2, 7}};

TEST(Diagnosis, Damping) {
  const Matrix c{{0.2, -0.1, 0}, {-0.1, 0.3, -0.2}, {0, -0.2, 0.2}};
  for (const double scale : {1e-6, 1.0, 1e6}) {
    expect_said(one, turning + scale * c, springs, "this is damping, C = (G + Gᵀ)/2");
    expect_said(one, turning - scale * c, springs, "damping that feeds energy in");
  }
  expect_said(one, turning + Matrix{{0.2, 0, 0}, {0, -0.1, 0}, {0, 0, 0}}, springs, "damping of both signs");
  expect_said(one, c, springs, "this is damping");  // damping given in the place of G
}

TEST(Diagnosis, Circulatory) {
  const Matrix n{{0, 0.3, 0.1}, {-0.3, 0, 0.2}, {-0.1, -0.2, 0}};
  for (const double scale : {1e-6, 1.0, 10.0}) expect_said(one, turning, springs + scale * n, "its skew part is circulatory");
  expect_said(Matrix::Identity(2, 2), Matrix::Zero(2, 2), Matrix{{9, 1}, {-1, 9}}, "its skew part is circulatory");
}

TEST(Diagnosis, OneEntryTypedWrong) {
  Matrix k = springs;
  k(1, 2) = -2;
  expect_said(one, turning, k, "was a sign typed wrong?");
  k(1, 2) = 2.2;
  expect_said(one, turning, k, "was one of the two typed wrong?");
}

TEST(Diagnosis, DividedByTheMasses) {
  const Matrix d = Eigen::Vector3d(2, 3, 0.5).asDiagonal();
  expect_said(one, d * turning, d * springs, "M⁻¹G and M⁻¹K");
  std::mt19937_64 source(4);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 20; ++k) {  // a matrix of random numbers is not taken for one
    const Matrix g = Matrix::NullaryExpr(3, 3, [&] { return normal(source); }), stiff = g.transpose() + springs;
    EXPECT_EQ(said_of(one, g, stiff).find("M⁻¹G"), std::string::npos);
  }
}

TEST(Diagnosis, Exchanged) {
  expect_said(one, springs, turning, "were they exchanged?");
  expect_said(Matrix{{1, 3, 0}, {3, 1, 0}, {0, 0, 1}}, turning, springs, "were M and K exchanged?");
}

TEST(Diagnosis, TheRemedyWorks) {
  const Matrix k = springs + 0.013 * Matrix{{0, 1, 1}, {-1, 0, 0}, {-1, 0, 0}};
  const std::string said = said_of(one, turning, k);
  const std::size_t at = said.find("--symmetrise=");
  ASSERT_NE(at, std::string::npos) << said;
  const double tolerance = std::stod(said.substr(at + 13));
  EXPECT_NO_THROW(System(one, turning, k, {}, {.symmetrise = tolerance}));
  EXPECT_LE(tolerance, 2 * 0.026 / 7);
}

}  // namespace
}  // namespace gyromode
