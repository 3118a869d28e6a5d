// Large matrices from files: kind = "matrices", kind = "structure" with G by its own file, and matrix files alone.
#include "gyromode/base/error.h"
#include "gyromode/read/read_model.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>

namespace gyromode {
namespace {

// N masses of 1 in a row on springs of 1 between walls, each free across two axes and with a gyroscopic force g: M = 1,
// K = tridiag(−1, 2, −1) twice, G = g [0, 1; −1, 0] a mass. Frequencies ±g/2 + √(g²/4 + ω_k²), ω_k = 2 sin(kπ / (2(N +
// 1))).
class Files {
 public:
  static constexpr Index masses = 3000;
  static constexpr double g = 0.01;

  Files() : folder_(std::filesystem::temp_directory_path() / fmt::format("gyromode_large_{}", ::getpid())) {
    std::filesystem::create_directories(folder_);
    std::string m, k, lower, whole;
    for (Index i = 1; i <= 2 * masses; ++i) {
      m += fmt::format("{0} {0} 1\n", i);
      k += fmt::format("{0} {0} 2\n", i);
      if (i > 2) k += fmt::format("{} {} -1\n", i, i - 2);
      if (i % 2 == 0) lower += fmt::format("{} {} {}\n", i, i - 1, -g);
      if (i % 2 == 0) whole += fmt::format("{0} {1} {3}\n{1} {0} {2}\n", i, i - 1, g, -g);
    }
    write("M.mtx", "symmetric", 2 * masses, m);
    write("K.mtx", "symmetric", 4 * masses - 2, k);
    write("G.mtx", "skew-symmetric", masses, lower);
    write("whole.mtx", "general", 2 * masses, whole);
  }
  ~Files() { std::filesystem::remove_all(folder_); }

  std::filesystem::path at(const std::string& name) const { return folder_ / name; }
  void text(const std::string& name, const std::string& content) const {
    std::FILE* f = std::fopen(at(name).c_str(), "w");
    std::fputs(content.c_str(), f);
    std::fclose(f);
  }

 private:
  void write(const std::string& name, const char* symmetry, Index entries, const std::string& lines) const {
    text(name, fmt::format("%%MatrixMarket matrix coordinate real {}\n{} {} {}\n{}", symmetry, 2 * masses, 2 * masses, entries, lines));
  }
  std::filesystem::path folder_;
};

void expect_lowest(const Model& model, double g) {
  ModesOptions o;
  o.lowest = 5;
  const ModesResult r = model.modes(o);
  EXPECT_TRUE(r.is_complete()) << r.coverage.reason;
  ASSERT_GE(r.modes.size(), 5u);
  for (std::size_t k = 0; k < 5; ++k) {  // the lower of each pair
    const double w = 2 * std::sin(static_cast<double>(k + 1) * std::numbers::pi / (2 * (Files::masses + 1.0)));
    EXPECT_NEAR(r.modes[k].omega, std::sqrt(0.25 * g * g + w * w) - 0.5 * g, 1e-13) << k;
  }
}

TEST(LargeMatrices, OfEveryWayIn) {
  const Files files;
  MatrixFiles three;
  three.mass = files.at("M.mtx");
  three.gyroscopic = files.at("G.mtx");
  three.stiffness = files.at("K.mtx");
  expect_lowest(read_matrices(three), Files::g);
  files.text("matrices.toml", "kind = \"matrices\"\nmass = \"M.mtx\"\ngyroscopic = \"whole.mtx\"\nstiffness = \"K.mtx\"\n");
  const Model model = read_model(files.at("matrices.toml"));
  expect_lowest(model, Files::g);
  EXPECT_EQ(model.frame, Frame::unknown);
  EXPECT_EQ(model.files.size(), 4u);
  files.text("structure.toml", "kind = \"structure\"\nmass = \"M.mtx\"\ngyroscopic = \"G.mtx\"\nstiffness = \"K.mtx\"\n");
  expect_lowest(read_model(files.at("structure.toml")), Files::g);
  EXPECT_EQ(read_model(files.at("structure.toml")).frame, Frame::unknown);
}

TEST(LargeMatrices, WhatIsRefused) {
  const Files files;
  const auto refused = [&](const std::string& toml, const std::string& why) {
    files.text("model.toml", toml);
    try {
      read_model(files.at("model.toml"));
      ADD_FAILURE() << why;
    } catch (const Error& e) {
      EXPECT_NE(std::string(e.what()).find(why), std::string::npos) << e.what();
    }
  };
  const std::string large = "kind = \"matrices\"\nmass = \"M.mtx\"\nstiffness = \"K.mtx\"\n";
  refused(large + "spin = 3\n", "'spin' is for dense matrices");
  refused(large + "gyroscopic = \"K.mtx\"\n", "skew");
  refused("kind = \"matrices\"\nmass = \"M.mtx\"\nstiffness = \"G.mtx\"\n", "the banner of a symmetric matrix");
  refused("kind = \"structure\"\nmass = \"M.mtx\"\nstiffness = \"K.mtx\"\ngyroscopic = \"G.mtx\"\nspin = 3\n",
          "'spin' is for G that is made of M");
  files.text("bad.mtx", "%%MatrixMarket matrix coordinate real general\n6000 6000 3\n1 2 1\n2 1 3\n3 3 1\n");
  refused("kind = \"matrices\"\nmass = \"M.mtx\"\nstiffness = \"bad.mtx\"\n", "entry (2, 1) is 3 and entry (1, 2) is 1");
}

}  // namespace
}  // namespace gyromode
