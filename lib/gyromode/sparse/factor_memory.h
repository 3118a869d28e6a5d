#pragma once

#include <filesystem>
#include <limits>

namespace gyromode {

/// What factorisations of sparse matrices may take of this machine: one for the process, as its memory is.
struct FactorMemory {
  /// Bytes that the process may come to with a factorisation; infinite: what the machine has free, or the process is
  /// limited to. One that would need more keeps its factor in files, and one that needs more even so is not begun.
  double most = std::numeric_limits<double>::infinity();
  /// The folder of those files, which are deleted with the factor; empty: TMPDIR, /var/tmp or the system's.
  std::filesystem::path scratch;
};

/// From now on.
void set_factor_memory(const FactorMemory& memory);

namespace sparse {

const FactorMemory& factor_memory();
/// The folder for files of factors.
std::filesystem::path scratch_folder();
/// Bytes that the process may take beyond those that it has; infinite where that is not known. Where that is less than
/// `wanted`, what the C library keeps of freed memory is given back first.
double memory_left(double wanted);

}  // namespace sparse

}  // namespace gyromode
