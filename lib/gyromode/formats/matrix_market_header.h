#pragma once

#include "gyromode/formats/matrix_market.h"
#include "gyromode/formats/text_lines.h"

#include <string_view>

namespace gyromode::io {

inline constexpr std::string_view banner_form = "%%MatrixMarket matrix coordinate|array real|integer general|symmetric|skew-symmetric";

/// What the first line of a Matrix Market file says.
struct Banner {
  bool coordinate = true;
  bool integer = false;
  Symmetry symmetry = Symmetry::general;
};

/// The size line, checked: what it promises fits a dense matrix.
struct Size {
  Index rows = 0;
  Index cols = 0;
  Index entries = 0;     // stored in the file: of the lower triangle, where there is symmetry
  std::size_t line = 0;  // where the file says so
};

/// Throw Unreadable with line, value and expectation.
Banner read_banner(Lines& lines);
Size read_size(Lines& lines, const Banner& banner);

}  // namespace gyromode::io
