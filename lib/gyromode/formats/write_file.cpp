#include "gyromode/formats/write_file.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <system_error>

namespace gyromode::io {

void write_file(const std::filesystem::path& file, std::string_view content) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::is_directory(file, error)) throw Unreadable(file, "is a directory: a file to write was expected");
  // A pipe or a device (/dev/stdout) has no beside to rename from.
  const bool in_place = fs::exists(file, error) && !fs::is_regular_file(file, error);
  const fs::path beside = in_place ? file : fs::path(fmt::format("{}.{}.part", file.string(), ::getpid()));
  {
    std::ofstream out(beside, std::ios::binary);
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
    out.flush();
    if (!out) {
      if (!in_place) fs::remove(beside, error);
      throw Unreadable(file, "cannot be written (does the folder exist, is there room?)");
    }
  }
  if (in_place) return;
  fs::rename(beside, file, error);
  if (error) {
    const std::string why = error.message();
    fs::remove(beside, error);
    throw Unreadable(file, fmt::format("cannot be replaced: {}", why));
  }
}

}  // namespace gyromode::io
