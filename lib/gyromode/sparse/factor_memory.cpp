#include "gyromode/sparse/factor_memory.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace gyromode {

namespace {

FactorMemory& of_this_process() {
  static FactorMemory memory;
  return memory;
}

constexpr double unknown = std::numeric_limits<double>::infinity();

constexpr double kilobyte = 1024, byte = 1;

// The number behind a name in one of Linux's tables, such as "MemAvailable:  123 kB", in bytes.
double entry_of(const char* file, const std::string& name, double unit) {
  std::ifstream in(file);
  std::string word;
  double value = 0;
  while (in >> word) {
    if (word == name && in >> value) return value * unit;
  }
  return unknown;
}

double number_in(const char* file) {
  double value = 0;
  std::ifstream in(file);
  return in >> value ? value : unknown;
}

// What a container or a batch job has left of its limit; files held in memory give way.
double left_to_group() {
  const double limit = number_in("/sys/fs/cgroup/memory.max"), taken = number_in("/sys/fs/cgroup/memory.current"),
               files = entry_of("/sys/fs/cgroup/memory.stat", "file", byte);
  if (limit == unknown || taken == unknown) return unknown;
  return std::max(0.0, limit - (files == unknown ? taken : taken - files));
}

}  // namespace

void set_factor_memory(const FactorMemory& memory) { of_this_process() = memory; }

namespace sparse {

const FactorMemory& factor_memory() { return of_this_process(); }

std::filesystem::path scratch_folder() {
  if (!factor_memory().scratch.empty()) return factor_memory().scratch;
  if (const char* folder = std::getenv("TMPDIR")) return folder;
  std::error_code error;
  const std::filesystem::path lasting = "/var/tmp";  // /tmp may be in memory itself
  return std::filesystem::is_directory(lasting, error) ? lasting : std::filesystem::temp_directory_path(error);
}

namespace {

double left_now() {
  if (factor_memory().most == unknown) return std::min(entry_of("/proc/meminfo", "MemAvailable:", kilobyte), left_to_group());
  const double taken = entry_of("/proc/self/status", "VmRSS:", kilobyte);
  return taken < unknown ? std::max(0.0, factor_memory().most - taken) : factor_memory().most;
}

}  // namespace

double memory_left(double wanted) {
  const double left = left_now();
  if (left >= wanted) return left;
#ifdef __GLIBC__
  malloc_trim(0);
#endif
  return left_now();
}

}  // namespace sparse

}  // namespace gyromode
