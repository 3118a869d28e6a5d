#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// SHA-256 of everything added, in hexadecimal (libmd), and the files that it is from.
class Digest {
 public:
  void add(std::string_view bytes) { bytes_ += bytes; }
  /// Of a file, which is remembered.
  void add(const std::filesystem::path& file, std::string_view bytes) {
    bytes_ += bytes;
    files_.push_back(file);
  }
  /// Of a file that is not held in memory: by its own SHA-256. What cannot be read is left to who reads it.
  void add_large(const std::filesystem::path& file);
  const std::vector<std::filesystem::path>& files() const { return files_; }
  std::string sha256() const;

 private:
  std::string bytes_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace gyromode::io
