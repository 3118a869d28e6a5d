#include "machine.h"

#include "gyromode/lapack/lapacke_complex.h"
#include "gyromode/version.h"

#include <cblas.h>
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <sstream>
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

// user, nice, system, idle, iowait, irq, softirq, steal of the first line of /proc/stat, without the two idle ones.
double busy_seconds() {
  std::istringstream line(first_line("/proc/stat"));
  std::string cpu;
  line >> cpu;
  double sum = 0, ticks = 0;
  for (int field = 0; field < 8 && line >> ticks; ++field) {
    if (field != 3 && field != 4) sum += ticks;
  }
  return sum / static_cast<double>(sysconf(_SC_CLK_TCK));
}

double own_seconds(int who) {
  rusage usage{};
  getrusage(who, &usage);
  const auto seconds = [](const timeval& t) { return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec); };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
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

Others::Others() : start_(now()) {}

Others::Seconds Others::now() {
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now().time_since_epoch();
  return {busy_seconds(), own_seconds(RUSAGE_SELF) + own_seconds(RUSAGE_CHILDREN), wall.count()};
}

double Others::share() const {
  const Seconds end = now();
  const double others = (end.busy - start_.busy) - (end.own - start_.own);
  return std::clamp(others / ((end.wall - start_.wall) * std::max(1U, std::thread::hardware_concurrency())), 0.0, 1.0);
}

}  // namespace gyromode::bench
