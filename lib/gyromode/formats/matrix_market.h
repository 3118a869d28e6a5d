#pragma once

#include "gyromode/base/error.h"
#include "gyromode/base/types.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace gyromode {

/// Symmetry that a Matrix Market header declares. The file then stores the lower triangle (for skew-symmetric: without
/// the diagonal).
enum class Symmetry { general, symmetric, skew_symmetric };

/// Reads a dense n × m matrix from a Matrix Market file: coordinate or array; real or integer; general, symmetric or
/// skew-symmetric; comments, blank lines and CRLF are accepted. A header is never trusted: the number of entries is
/// checked against the content before memory is taken. Throws Unreadable for anything else, with line and value; an
/// entry given twice is an error (the rule chosen here: repeated entries are neither added nor overwritten), as is one
/// above the diagonal of a symmetric file.
Matrix read_matrix_market(const std::filesystem::path& file);

/// The same from text in memory; `name` stands for the file in messages. `most`: the largest order that serves the
/// caller; a size line beyond it is refused before a line of content is read.
Matrix parse_matrix_market(std::string_view text, const std::filesystem::path& name, std::optional<Index> most = std::nullopt);

/// Whether `entries` entries of a coordinate file may become a dense rows × cols matrix: it takes at most 256 MiB
/// (order 5792), or no side is beyond 46 000 and there is an entry for each row or each column, the lesser. The first
/// lets in a G of one wheel, two entries in 5000 coordinates; the second a diagonal of order 20 000; together they
/// refuse 10⁹ × 10⁹ with three entries.
bool fits_dense(Index rows, Index cols, Index entries);

/// Writes `a` in coordinate form, each value in the shortest form that reads back to the same double, entries that are
/// exactly zero left out (but for the diagonal, where fits_dense() asks for it); symmetric and skew-symmetric matrices
/// as their lower triangle. Written beside the target and renamed, so a failure leaves an existing file as it was.
/// Throws InvalidArgument where `a` is empty, not finite, or not exactly of the symmetry named.
void write_matrix_market(const std::filesystem::path& file, const Matrix& a, Symmetry symmetry, std::string_view comment = {});

/// The text that write_matrix_market() writes. Each line of `comment` becomes a line that starts with "% ".
std::string format_matrix_market(const Matrix& a, Symmetry symmetry, std::string_view comment = {});

}  // namespace gyromode
