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

}  // namespace gyromode::io
