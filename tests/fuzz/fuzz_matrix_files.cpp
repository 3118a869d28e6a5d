// libFuzzer: whatever the bytes, parse_matrices() returns matrices or throws one of our errors; what it returns is
// finite, and reads back the same from .npy and .npz. MATLAB files are libmatio's and are left out.
#include "gyromode/base/error.h"
#include "gyromode/formats/matlab.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/formats/numpy.h"

#include <cstdint>
#include <cstdlib>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gyromode;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (io::is_matlab(bytes)) return 0;
  std::vector<NamedMatrix> all;
  try {
    all = parse_matrices(bytes, "fuzz.dat", 300);
  } catch (const Error&) {
    return 0;
  }
  for (const NamedMatrix& m : all) {
    if (!m.unfit.empty()) {  // passed over, with the reason
      if (m.matrix.size() != 0) std::abort();
      continue;
    }
    if (!m.matrix.allFinite() || (!m.labels.empty() && static_cast<Index>(m.labels.size()) != m.matrix.cols())) std::abort();
    if (m.matrix.size() == 0 || io::parse_npy(io::format_npy(m.matrix), "again.npy", std::nullopt) != m.matrix) std::abort();
  }
  return 0;
}
