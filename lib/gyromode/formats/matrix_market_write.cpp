#include "gyromode/formats/matrix_market.h"
#include "gyromode/base/error.h"
#include "gyromode/formats/write_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace gyromode {

namespace {

using namespace io;

std::string_view to_string(Symmetry symmetry) {
  switch (symmetry) {
    case Symmetry::symmetric: return "symmetric";
    case Symmetry::skew_symmetric: return "skew-symmetric";
    case Symmetry::general: break;
  }
  return "general";
}

void require_finite(const Matrix& a) {
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = 0; i < a.rows(); ++i) {
      if (std::isfinite(a(i, j))) continue;
      throw InvalidArgument(fmt::format("a Matrix Market file holds finite values: entry ({},{}) = {}", i, j, a(i, j)));
    }
  }
}

// A = Aᵀ or A = −Aᵀ to the last bit: the file holds one triangle, and the other would be lost.
void require_symmetry(const Matrix& a, Symmetry symmetry) {
  if (symmetry == Symmetry::general) return;
  if (a.rows() != a.cols()) {
    throw InvalidArgument(fmt::format("a {} matrix must be square: this one is {} x {}", to_string(symmetry), a.rows(), a.cols()));
  }
  const double sign = symmetry == Symmetry::symmetric ? 1 : -1;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = j; i < a.rows(); ++i) {
      if (a(i, j) == sign * a(j, i)) continue;
      const std::string met = i == j ? fmt::format("entry ({0},{0}) = {1} is not zero", i, a(i, i))
                                     : fmt::format("entries ({0},{1}) = {2} and ({1},{0}) = {3} do not match", i, j, a(i, j), a(j, i));
      throw InvalidArgument(fmt::format("a {} file holds the lower triangle only: {}", to_string(symmetry), met));
    }
  }
}

Index first_row(Index col, Symmetry symmetry) { return symmetry == Symmetry::general ? 0 : col; }

Index count_nonzeros(const Matrix& a, Symmetry symmetry) {
  Index count = 0;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = first_row(j, symmetry); i < a.rows(); ++i) count += a(i, j) != 0 ? 1 : 0;
  }
  return count;
}

std::string commented(std::string_view comment) {
  if (comment.find('\0') != std::string_view::npos) {
    throw InvalidArgument("a comment in a Matrix Market file must be text: it holds a NUL byte");
  }
  std::string out;
  while (!comment.empty()) {
    const std::size_t end = std::min(comment.find('\n'), comment.size());
    out += fmt::format("% {}\n", comment.substr(0, end));
    comment.remove_prefix(std::min(end + 1, comment.size()));
  }
  return out;
}

}  // namespace

std::string format_matrix_market(const Matrix& a, Symmetry symmetry, std::string_view comment) {
  if (a.size() == 0) {
    throw InvalidArgument(fmt::format("a Matrix Market file holds one row and column at least: this is {} x {}", a.rows(), a.cols()));
  }
  require_finite(a);
  require_symmetry(a, symmetry);
  // What is written must be read: a large matrix with few entries shows its diagonal, zeros included.
  const bool whole_diagonal = !fits_dense(a.rows(), a.cols(), count_nonzeros(a, symmetry));
  std::string entries;
  Index count = 0;
  for (Index j = 0; j < a.cols(); ++j) {
    for (Index i = first_row(j, symmetry); i < a.rows(); ++i) {
      if (a(i, j) == 0 && !(whole_diagonal && i == j)) continue;
      fmt::format_to(std::back_inserter(entries), "{} {} {}\n", i + 1, j + 1, a(i, j));
      ++count;
    }
  }
  const std::string banner = fmt::format("%%MatrixMarket matrix coordinate real {}\n", to_string(symmetry));
  return banner + commented(comment) + fmt::format("{} {} {}\n", a.rows(), a.cols(), count) + entries;
}

void write_matrix_market(const std::filesystem::path& file, const Matrix& a, Symmetry symmetry, std::string_view comment) {
  write_file(file, format_matrix_market(a, symmetry, comment));
}

}  // namespace gyromode
