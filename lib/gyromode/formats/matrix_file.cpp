#include "gyromode/formats/matrix_file.h"

#include "gyromode/formats/harwell_boeing.h"
#include "gyromode/formats/matlab.h"
#include "gyromode/formats/matrix_market.h"
#include "gyromode/formats/nastran.h"
#include "gyromode/formats/number_table.h"
#include "gyromode/formats/numpy.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace gyromode {

namespace {

using namespace io;

std::string names_of(const std::vector<NamedMatrix>& all) {
  constexpr std::size_t most = 12;
  std::string names;
  for (std::size_t k = 0; k < all.size() && k < most; ++k) names += fmt::format("{}{}", k == 0 ? "" : ", ", shown(all[k].name));
  return all.size() > most ? names + ", …" : names;
}

}  // namespace

std::string_view matrix_format(std::string_view bytes) {
  if (is_npy(bytes) || is_npz(bytes)) return "NumPy";
  if (is_op4(bytes)) return "OUTPUT4";
  if (is_matlab(bytes)) return "MATLAB";
  if (bytes.starts_with("%%MatrixMarket")) return "Matrix Market";
  if (is_dmig(bytes)) return "DMIG";
  return is_harwell_boeing(bytes) ? "Harwell–Boeing" : "";
}

std::vector<NamedMatrix> parse_matrices(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most) {
  if (is_npy(bytes)) return {{name.stem().string(), parse_npy(bytes, name, most), {}}};
  if (is_npz(bytes)) return parse_npz(bytes, name, most);
  if (is_op4(bytes)) return parse_op4(bytes, name, most);
  if (is_matlab(bytes)) return read_matlab(bytes, name, most);
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"))
    throw Unreadable(name, "is UTF-16 text: save it as UTF-8 (CSV UTF-8 in spreadsheets)");
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos) throw Unreadable(name, "is empty: a matrix was expected");
  const std::string_view text = bytes.starts_with("\xEF\xBB\xBF") ? bytes.substr(3) : bytes;
  if (text.starts_with("%%")) return {{name.stem().string(), parse_matrix_market(text, name, most), {}}};
  if (is_dmig(text)) return parse_dmig(text, name, most);
  if (is_harwell_boeing(text)) return {parse_harwell_boeing(text, name, most)};
  if (text.find('\0') != std::string_view::npos)
    throw Unreadable(
        name,
        "is a binary file of no format that is read: Matrix Market, .npy, .npz, .mat, OUTPUT4, DMIG, Harwell–Boeing or a table of "
        "numbers was expected (docs/formats.md)");
  return {parse_number_table(text, name, most)};
}

std::vector<NamedMatrix> read_matrices_of(const std::filesystem::path& file, std::optional<Index> most) {
  return parse_matrices(read_bytes(file, "matrix"), file, most);
}

MatrixPlace matrix_place(const std::filesystem::path& written) {
  std::error_code error;
  const std::string text = written.string();
  const std::size_t colon = text.rfind(':');
  if (std::filesystem::exists(written, error) || colon == std::string::npos || colon == 0) return {written, ""};
  return {text.substr(0, colon), text.substr(colon + 1)};
}

void make_square(NamedMatrix& m, const std::filesystem::path& file) {
  Matrix& a = m.matrix;
  if (a.rows() == a.cols()) return;
  if (std::min(a.rows(), a.cols()) != 1)
    throw Unreadable(file, fmt::format("'{}' has {} rows and {} columns: a square matrix was expected", shown(m.name), a.rows(), a.cols()));
  a = Matrix(Vector(a.reshaped()).asDiagonal());
  if (static_cast<Index>(m.labels.size()) != a.rows()) m.labels.clear();  // the heading of a column
}

void extend(NamedMatrix& m, Index order) {
  const Index n = m.matrix.rows();
  if (!m.may_go_on || n >= order) return;
  Matrix whole = Matrix::Zero(order, order);
  whole.topLeftCorner(n, n) = m.matrix;
  m.matrix = std::move(whole);
}

void require_fit(const NamedMatrix& m, const std::filesystem::path& file) {
  if (!m.unfit.empty()) throw Unreadable(file, fmt::format("'{}' {}: a matrix of real numbers was expected", shown(m.name), m.unfit));
}

NamedMatrix chosen_matrix(std::vector<NamedMatrix> all, const MatrixPlace& place) {
  if (place.name.empty()) {
    if (all.size() > 1) std::erase_if(all, [](const NamedMatrix& m) { return !m.unfit.empty(); });
    if (all.size() == 1) {
      require_fit(all.front(), place.file);
      return std::move(all.front());
    }
    throw Unreadable(place.file, fmt::format("holds {} matrices ({}): one was expected, chosen as {}:NAME", all.size(), names_of(all),
                                             place.file.filename().string()));
  }
  for (NamedMatrix& m : all) {
    if (m.name != place.name) continue;
    require_fit(m, place.file);
    return std::move(m);
  }
  throw Unreadable(place.file, fmt::format("holds no matrix '{}': it has {}", shown(place.name), names_of(all)));
}

}  // namespace gyromode
