#pragma once

#include <filesystem>
#include <future>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// SHA-256 of everything added, in hexadecimal (libmd), and the files that it is from.
class Digest {
 public:
  void add(std::string_view bytes) { parts_.emplace_back().bytes = bytes; }
  /// Of a file, which is remembered.
  void add(const std::filesystem::path& file, std::string_view bytes) {
    add(bytes);
    files_.push_back(file);
  }
  /// Of a file that is not held in memory: by its own SHA-256, made beside other work. What cannot be read is left to
  /// who reads it.
  void add_large(const std::filesystem::path& file);
  const std::vector<std::filesystem::path>& files() const { return files_; }
  std::string sha256() const;

 private:
  struct Part {
    std::string bytes;
    std::shared_future<std::string> later;  // where it is valid: instead
  };
  std::vector<Part> parts_;
  std::vector<std::filesystem::path> files_;
};

}  // namespace gyromode::io
