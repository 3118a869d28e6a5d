// libFuzzer: whatever the bytes, parse_initial_state(), parse_times() and csv_rows() return finite values or throw
// Unreadable; a row that was read is written and read back as the same one.
#include "gyromode/base/error.h"
#include "gyromode/formats/csv.h"
#include "gyromode/read/initial_state.h"

#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

namespace {

template <class Read>
void value_or_unreadable(Read&& read) {
  try {
    read();
  } catch (const gyromode::Unreadable&) {
  }
}

void require(bool law) {
  if (!law) std::abort();
}

std::string joined(const gyromode::io::CsvRow& row) {
  std::string text;
  for (std::size_t k = 0; k < row.fields.size(); ++k) text += (k == 0 ? "" : ",") + gyromode::io::csv_field(row.fields[k]);
  return text;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text{reinterpret_cast<const char*>(data), size};
  value_or_unreadable([&] {
    const gyromode::State state = gyromode::io::parse_initial_state(text, "fuzz.csv", {"x", "y"});
    require(state.q.size() == 2 && state.qdot.size() == 2 && state.q.allFinite() && state.qdot.allFinite());
  });
  value_or_unreadable([&] {
    const gyromode::Vector t = gyromode::io::parse_times(text, "fuzz.csv");
    for (gyromode::Index k = 0; k < t.size(); ++k) require(t(k) >= 0 && (k == 0 || t(k) > t(k - 1)));
  });
  value_or_unreadable([&] {
    for (const gyromode::io::CsvRow& row : gyromode::io::csv_rows(text, "fuzz.csv")) {
      const std::string once = joined(row);
      const auto again = gyromode::io::csv_rows(once, "again.csv");
      if (once.empty()) continue;  // a blank line
      require(again.size() == 1 && again.front().fields == row.fields);
    }
  });
  return 0;
}
