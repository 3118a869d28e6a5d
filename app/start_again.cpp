#include "start_again.h"

#include "gyromode/read/read_model.h"

#ifdef __linux__
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#endif

namespace gyromode::app {

#ifdef __linux__

namespace {

std::string all_of(const char* file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Where the system gives large pages to those who ask.
std::string large_pages() {
  const bool on_request = all_of("/sys/kernel/mm/transparent_hugepage/enabled").find("[madvise]") != std::string::npos;
  return on_request ? "glibc.malloc.hugetlb=1" : "";
}

}  // namespace

void start_again_for_large(const std::vector<std::string>& files) {
  constexpr std::uintmax_t large = 20'000'000;
  std::uintmax_t bytes = 0;
  for (const std::string& file : files) bytes += bytes_to_read(file);
  if (bytes < large) return;
  const std::string pages = large_pages();
  constexpr const char* variable = "GLIBC_TUNABLES";
  if (pages.empty() || std::getenv(variable) || setenv(variable, pages.c_str(), 0) != 0) return;
  std::string line = all_of("/proc/self/cmdline");  // words that end with a zero each
  std::vector<char*> words;
  for (std::size_t at = 0; at < line.size(); at += std::strlen(words.back()) + 1) words.push_back(line.data() + at);
  if (words.empty()) return;
  words.push_back(nullptr);
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);  // under its own name
  if (!error) execv(program.c_str(), words.data());
}

#else

void start_again_for_large(const std::vector<std::string>&) {}

#endif

}  // namespace gyromode::app
