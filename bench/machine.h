#pragma once

#include <string>

namespace gyromode::bench {

/// What a number depends on besides the code. Read at the start of a run.
struct Machine {
  std::string cpu;       ///< "model name" of /proc/cpuinfo
  unsigned cores = 0;    ///< that this process may run on
  double memory_gb = 0;  ///< MemTotal of /proc/meminfo
  std::string load;      ///< /proc/loadavg: others on a shared machine
  std::string compiler;
  std::string build;     ///< CMake's build type and flags
  std::string lapack;    ///< version that LAPACKE reports
  std::string openblas;  ///< openblas_get_config
  std::string core;      ///< openblas_get_corename: which kernels it chose
  int threads = 0;       ///< openblas_get_num_threads
  std::string gyromode;
  std::string date;  ///< UTC
};

Machine this_machine();

/// How much of the machine's processors others used since construction, from /proc/stat and getrusage: 0 quiet, 1 all
/// of it.
class Others {
 public:
  Others();
  double share() const;

 private:
  struct Seconds {
    double busy, own, wall;
  };
  static Seconds now();
  Seconds start_;
};

}  // namespace gyromode::bench
