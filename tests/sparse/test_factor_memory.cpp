// Where factors are kept, and what M is made of.
#include "as_dense.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/modes.h"
#include "gyromode/sparse/components.h"
#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/factor_memory.h"
#include "gyromode/sparse/node_order.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <numeric>
#include <string>

namespace gyromode {
namespace {

using sparse::SymmetricFactor;

// 7-point differences in a cube of side³ points, less `shift`: K of a membrane in space.
SparseMatrix cube(Index side, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto at = [&](Index x, Index y, Index z) { return static_cast<int>((x * side + y) * side + z); };
  for (Index x = 0; x < side; ++x) {
    for (Index y = 0; y < side; ++y) {
      for (Index z = 0; z < side; ++z) {
        entries.emplace_back(at(x, y, z), at(x, y, z), 6 - shift);
        if (x + 1 < side) entries.emplace_back(at(x + 1, y, z), at(x, y, z), -1.0);
        if (y + 1 < side) entries.emplace_back(at(x, y + 1, z), at(x, y, z), -1.0);
        if (z + 1 < side) entries.emplace_back(at(x, y, z + 1), at(x, y, z), -1.0);
      }
    }
  }
  SparseMatrix a(side * side * side, side * side * side);
  a.setFromTriplets(entries.begin(), entries.end());
  return a;
}

std::vector<int> order_of(const SparseMatrix& a) {
  std::vector<int> node(static_cast<std::size_t>(a.cols()));
  std::iota(node.begin(), node.end(), 0);
  return sparse::coordinate_order(sparse::node_places({&a}, node), node);
}

class FactorMemoryTest : public ::testing::Test {
 protected:
  void SetUp() override {
    scratch_ = std::filesystem::temp_directory_path() / fmt::format("gyromode_scratch_{}", ::getpid());
    std::filesystem::create_directories(scratch_);
  }
  void TearDown() override {
    set_factor_memory({});
    std::filesystem::remove_all(scratch_);
  }
  // So many megabytes beyond what the process has.
  void leave(double megabytes) const {
    constexpr double much = 1e15;
    set_factor_memory({much, scratch_});
    const double taken = much - sparse::memory_left(2 * much);
    set_factor_memory({taken + 1e6 * megabytes, scratch_});
  }
  Index files() const { return std::distance(std::filesystem::directory_iterator(scratch_), {}); }

  std::filesystem::path scratch_;
};

TEST_F(FactorMemoryTest, FactorsTooLargeForMemoryAreInFilesAndSolveTheSame) {
  const SparseMatrix k = cube(24, 0.3);
  const std::vector<int> order = order_of(k);
  const Matrix b = Matrix::Random(k.cols(), 5);
  for (const auto kind : {SymmetricFactor::Kind::definite, SymmetricFactor::Kind::indefinite}) {
    set_factor_memory({});
    SymmetricFactor in_memory(k, order, SymmetricFactor::Keep::factors, kind);
    const Index negative = in_memory.factor(k);
    ASSERT_FALSE(in_memory.in_files());
    EXPECT_GT(negative, 0);
    const Matrix x = in_memory.solve(b);
    {
      SymmetricFactor f(k, order, SymmetricFactor::Keep::factors, kind);
      ASSERT_LT(f.megabytes_beside_files(), 0.7 * f.megabytes());
      leave(0.5 * (f.megabytes() + f.megabytes_beside_files()));
      EXPECT_EQ(f.factor(k), negative);
      EXPECT_TRUE(f.in_files());
      EXPECT_GT(files(), 0);
      EXPECT_LT((f.solve(b) - x).norm(), 1e-10 * x.norm());
      const SparseMatrix other = cube(24, 0);  // another one of the pattern
      EXPECT_EQ(f.factor(other), 0);
      EXPECT_TRUE((other.selfadjointView<Eigen::Lower>() * f.solve(b)).isApprox(b, 1e-10));
    }
    EXPECT_EQ(files(), 0) << "they are deleted with the factor";
  }
}

TEST_F(FactorMemoryTest, WhatNeedsMoreEvenSoIsNotBegun) {
  const SparseMatrix k = cube(24, 0);
  const std::vector<int> order = order_of(k);
  for (const auto keep : {SymmetricFactor::Keep::factors, SymmetricFactor::Keep::counts}) {
    SymmetricFactor f(k, order, keep);
    leave(1);
    try {
      f.factor(k);
      ADD_FAILURE();
    } catch (const TooLarge& e) {
      const std::string said = e.what();
      EXPECT_NE(said.find(fmt::format("{:.0f} MB", f.megabytes_beside_files())), std::string::npos) << said;
      EXPECT_NE(said.find("--memory"), std::string::npos) << said;
      EXPECT_EQ(said.find("in files") != std::string::npos, keep == SymmetricFactor::Keep::factors) << said;
    }
  }
}

TEST_F(FactorMemoryTest, AFolderThatIsNotThereIsNamed) {
  const SparseMatrix k = cube(24, 0);
  SymmetricFactor f(k, order_of(k), SymmetricFactor::Keep::factors);
  std::filesystem::remove_all(scratch_);
  leave(0.5 * (f.megabytes() + f.megabytes_beside_files()));
  try {
    f.factor(k);
    ADD_FAILURE();
  } catch (const TooLarge& e) {
    EXPECT_NE(std::string(e.what()).find(scratch_.string()), std::string::npos) << e.what();
  }
}

TEST_F(FactorMemoryTest, ModesAreTheSame) {
  const SparseMatrix k = cube(16, 0), m = SparseMatrix(Matrix::Identity(k.cols(), k.cols()).sparseView());
  SparseMatrix g(k.cols(), k.cols());
  for (Index j = 0; j + 1 < k.cols(); j += 2) g.insert(j + 1, j) = 0.1;
  const SparseSystem s({m, g, k, {}, {}});
  ModesOptions o;
  o.lowest = 12;
  const ModesResult before = find_modes(s, o);
  const auto plan = plan_of(s);
  leave(plan.back().megabytes_beside_files + 60);  // with the vectors
  const ModesResult after = find_modes(s, o);
  ASSERT_EQ(before.modes.size(), after.modes.size());
  EXPECT_TRUE(before.is_complete() && after.is_complete());
  for (std::size_t i = 0; i < before.modes.size(); ++i) EXPECT_NEAR(before.modes[i].omega, after.modes[i].omega, 1e-11);
}

TEST(MassLaw, ComponentsAreSetsOfCoupledCoordinates) {
  Matrix a = Matrix::Zero(7, 7);
  for (const auto& [i, j] : {std::pair<Index, Index>{6, 0}, {4, 2}, {6, 4}, {3, 1}}) a(i, j) = a(j, i) = 1;
  a.diagonal().setOnes();
  using Sets = std::vector<std::vector<Index>>;
  EXPECT_EQ(sparse::components_of(support::lower_of(a)), (Sets{{0, 2, 4, 6}, {1, 3}, {5}}));
  EXPECT_EQ(sparse::components_of(SparseMatrix(0, 0)), Sets{});
}

// Three blocks, two of them the same; one is singular, or indefinite.
TEST(MassLaw, HoldsForEveryBlock) {
  constexpr Index n = 40;
  Matrix block = 4 * Matrix::Identity(n, n);
  block.diagonal(1).setOnes();
  block.diagonal(-1).setOnes();
  Matrix free = 2 * Matrix::Identity(n, n);  // of eigenvalue 0 along ones
  free.diagonal(1).setConstant(-1);
  free.diagonal(-1).setConstant(-1);
  free(0, 0) = free(n - 1, n - 1) = 1;
  Matrix indefinite = free;
  indefinite.diagonal().array() -= 1e-3;
  const SparseMatrix none(3 * n, 3 * n);
  for (Index which = 0; which < 3; ++which) {
    for (const auto& [odd, negative] : {std::pair(&block, 0), {&free, 0}, {&indefinite, 1}}) {
      Matrix m = Matrix::Zero(3 * n, 3 * n);
      for (Index b = 0; b < 3; ++b) m.block(b * n, b * n, n, n) = b == which ? *odd : block;
      const SparseMatrix lower = support::lower_of(m);
      if (negative > 0) {
        EXPECT_THROW(SparseSystem({lower, none, lower, {}, {}}), LawBroken);
      } else {
        EXPECT_EQ(SparseSystem({lower, none, lower, {}, {}}).singular_mass(), odd == &free);
      }
    }
  }
}

}  // namespace
}  // namespace gyromode
