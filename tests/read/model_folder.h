#pragma once

#include "gyromode/base/error.h"
#include "gyromode/read/read_model.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace gyromode::io {

namespace fs = std::filesystem;

inline constexpr const char* mtx_m = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2\n2 2 3\n";
inline constexpr const char* mtx_g = "%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 4\n";
inline constexpr const char* mtx_k = "%%MatrixMarket matrix array real symmetric\n2 2\n5\n-1\n7\n";

// A folder of its own for each test, with the models and matrices it writes.
class ModelFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "gyromode-model-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  Model read(std::string_view text) const { return read_model(write("model.toml", text)); }

  // The message of an Unreadable, names without the folder.
  std::string error(std::string_view text) const {
    try {
      read(text);
    } catch (const Unreadable& e) {
      return without_folder(e.what());
    }
    return "(accepted)";
  }

  std::string broken(std::string_view text) const {
    try {
      read(text);
    } catch (const LawBroken& e) {
      return e.what();
    }
    return "(accepted)";
  }

  std::string without_folder(std::string message) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) message.erase(at, prefix.size());
    return message;
  }

  fs::path folder_;
};

}  // namespace gyromode::io
