// libFuzzer: whatever the bytes, parse_matrix_market() returns a matrix or throws Unreadable; a matrix it returns is
// written and read back as the same one.
#include "gyromode/base/error.h"
#include "gyromode/formats/matrix_market.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace {

using gyromode::Matrix;
using gyromode::Symmetry;

void require_round_trip(const Matrix& a, Symmetry symmetry) {
  const Matrix again = gyromode::parse_matrix_market(gyromode::format_matrix_market(a, symmetry, "fuzz\nround trip"), "again.mtx");
  if (!a.allFinite() || again.rows() != a.rows() || again.cols() != a.cols() || !(again.array() == a.array()).all()) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Matrix a;
  try {
    a = gyromode::parse_matrix_market({reinterpret_cast<const char*>(data), size}, "fuzz.mtx");
  } catch (const gyromode::Unreadable&) {
    return 0;
  }
  if (a.size() > 100'000) return 0;  // nearly all zeros, and slow to walk
  require_round_trip(a, Symmetry::general);
  if (a.rows() != a.cols()) return 0;
  if (a == a.transpose()) require_round_trip(a, Symmetry::symmetric);
  if (a == -a.transpose()) require_round_trip(a, Symmetry::skew_symmetric);
  return 0;
}
