#include "gyromode/formats/digest.h"

#include <sys/types.h>

#include <sha2.h>

#include <array>
#include <cstdint>

namespace gyromode::io {

std::string Digest::sha256() const {
  std::string all;
  for (const Part& p : parts_) all += p.later.valid() ? p.later.get() : p.bytes;
  std::array<char, SHA256_DIGEST_STRING_LENGTH> hex{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(all.data()), all.size(), hex.data());
  return hex.data();
}

void Digest::add_large(const std::filesystem::path& file) {
  const auto digest = [file]() -> std::string {
    std::array<char, SHA256_DIGEST_STRING_LENGTH> hex{};
    return SHA256File(file.c_str(), hex.data()) ? hex.data() : "";
  };
  parts_.emplace_back().later = std::async(std::launch::async, digest).share();
  files_.push_back(file);
}

}  // namespace gyromode::io
