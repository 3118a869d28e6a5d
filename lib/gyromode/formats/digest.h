#pragma once

#include <string>
#include <string_view>

namespace gyromode::io {

/// SHA-256 of everything added, in hexadecimal (libmd).
class Digest {
 public:
  void add(std::string_view bytes) { bytes_ += bytes; }
  std::string sha256() const;

 private:
  std::string bytes_;
};

}  // namespace gyromode::io
