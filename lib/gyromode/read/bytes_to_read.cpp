#include "gyromode/base/error.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/read/read_model.h"
#include "gyromode/read/toml_text.h"

#include <system_error>

namespace gyromode {

namespace {

std::uintmax_t size_of(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::is_regular_file(file, error) ? std::filesystem::file_size(file, error) : 0;
  return error ? 0 : size;
}

}  // namespace

std::uintmax_t bytes_to_read(const std::filesystem::path& file) {
  std::uintmax_t all = size_of(file);
  if (file.extension() != ".toml" || all == 0) return all;
  try {
    const toml::table table = io::parse_toml(io::read_text(file, "a model"), file);
    for (const auto& [key, value] : table) {
      if (const auto text = value.value<std::string>()) all += size_of(file.parent_path() / *text);
    }
  } catch (const Error&) {  // whoever reads it will say
  }
  return all;
}

}  // namespace gyromode
