#include "machine.h"

#include "gyromode/lapack/lapacke_complex.h"
#include "gyromode/version.h"

#include <cblas.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>
#include <fstream>
#include <thread>

namespace gyromode::bench {

namespace {

// What follows the colon of the first line "key …: value".
std::string value_of(const char* file, const std::string& key) {
  std::ifstream lines(file);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key)) continue;
    const auto at = line.find_first_not_of(" \t", line.find(':') + 1);
    return at == std::string::npos ? "" : line.substr(at);
  }
  return "unknown";
}

std::string first_line(const char* file) {
  std::ifstream lines(file);
  std::string line;
  std::getline(lines, line);
  return line;
}

std::string lapack_version() {
  lapack_int major = 0, minor = 0, patch = 0;
  LAPACKE_ilaver(&major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

double gigabytes(const std::string& kilobytes) { return kilobytes == "unknown" ? 0 : std::stod(kilobytes) / (1024 * 1024); }

}  // namespace

Machine this_machine() {
  Machine m;
  m.cpu = value_of("/proc/cpuinfo", "model name");
  m.cores = std::thread::hardware_concurrency();
  m.memory_gb = gigabytes(value_of("/proc/meminfo", "MemTotal"));
  m.load = first_line("/proc/loadavg");
  m.compiler = "GCC " __VERSION__;
#ifdef __clang__
  m.compiler = __VERSION__;
#endif
#ifdef GYROMODE_BENCH_BUILD
  m.build = GYROMODE_BENCH_BUILD;
#else
  m.build = "unknown";
#endif
  m.lapack = lapack_version();
  m.openblas = openblas_get_config();
  m.core = openblas_get_corename();
  m.threads = openblas_get_num_threads();
  m.gyromode = version();
  m.date = fmt::format("{:%FT%TZ}", fmt::gmtime(std::time(nullptr)));
  return m;
}

}  // namespace gyromode::bench
