#include "gyromode/formats/text_file.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

namespace gyromode::io {

namespace {

std::string read(const std::filesystem::path& file, std::string_view what, bool text_only) {
  constexpr std::size_t gibibyte = std::size_t{1} << 30;
  std::error_code error;
  const bool regular = std::filesystem::is_regular_file(file, error);
  const std::size_t most = (regular ? 4 : 1) * gibibyte;
  if (std::filesystem::is_directory(file, error)) throw Unreadable(file, fmt::format("is a directory: a {} file was expected", what));
  std::ifstream in(file, std::ios::binary);
  if (!in) {
    const std::string why = std::generic_category().message(errno);
    throw Unreadable(file, fmt::format("cannot be opened ({}): a {} file was expected", why, what));
  }
  std::string text;
  std::vector<char> chunk(1 << 16);
  do {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    const auto end = chunk.begin() + in.gcount();
    const auto nul = text_only ? std::find(chunk.begin(), end, '\0') : end;
    text.append(chunk.begin(), nul);
    if (nul != end) {
      const auto line = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
      throw Unreadable(file, line, 0, fmt::format("byte '\\x00' is not text: this is a binary file, a {} file was expected", what));
    }
    if (text.size() > most)
      throw Unreadable(file, fmt::format("is larger than {} GiB{}: more than a dense model can need", most / gibibyte,
                                         regular ? "" : " and no regular file"));
  } while (in);
  if (in.bad()) throw Unreadable(file, fmt::format("cannot be read beyond byte {}", text.size()));
  return text;
}

}  // namespace

std::string read_text(const std::filesystem::path& file, std::string_view what) { return read(file, what, true); }
std::string read_bytes(const std::filesystem::path& file, std::string_view what) { return read(file, what, false); }

std::string start_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return "";
  std::string bytes(4096, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

std::string shown(std::string_view piece) {
  constexpr std::size_t most = 40;
  std::string out;
  for (const char c : piece.substr(0, most)) {
    if (c >= ' ' && c <= '~') {
      out += c;
    } else {
      out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
    }
  }
  return piece.size() > most ? out + "..." : out;
}

}  // namespace gyromode::io
