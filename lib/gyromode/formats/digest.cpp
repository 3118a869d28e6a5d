#include "gyromode/formats/digest.h"

#include <sys/types.h>

#include <sha2.h>

#include <array>
#include <cstdint>

namespace gyromode::io {

std::string Digest::sha256() const {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> hex{};
  SHA256Data(reinterpret_cast<const std::uint8_t*>(bytes_.data()), bytes_.size(), hex.data());
  return hex.data();
}

void Digest::add_large(const std::filesystem::path& file) {
  std::array<char, SHA256_DIGEST_STRING_LENGTH> hex{};
  if (SHA256File(file.c_str(), hex.data())) bytes_ += hex.data();
  files_.push_back(file);
}

}  // namespace gyromode::io
