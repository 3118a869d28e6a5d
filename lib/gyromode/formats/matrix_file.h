#pragma once

#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/base/types.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// A matrix of a file, with the name that it has there; in files without names that of the file.
struct NamedMatrix {
  std::string name;        ///< "M", "KAAX"
  Matrix matrix;           ///< dense
  Labels labels = {};      ///< of rows and columns, where the file names them: "12.3" is direction 3 of grid point 12
  std::string unfit = {};  ///< why it is no matrix of real numbers ("is complex"); `matrix` is empty then
  bool may_go_on = false;  ///< a list of entries: rows and columns of zeros may follow
};

/// All matrices of a file, recognised by its content and not by its name: Matrix Market, NumPy .npy and .npz (dense,
/// and scipy.sparse's layout), MATLAB .mat (v4 to v7.3, dense and sparse), Harwell–Boeing and Rutherford–Boeing,
/// Nastran DMIG and OUTPUT4 (text and binary, dense and sparse, both endians), tables of numbers (CSV). `most`: the
/// largest order that serves the caller. @throws Unreadable with place, value and what was expected
std::vector<NamedMatrix> read_matrices_of(const std::filesystem::path& file, std::optional<Index> most = std::nullopt);

/// What a file is, of the formats that cannot be taken for anything else ("NumPy", "MATLAB", "Matrix Market", …); empty
/// for others.
std::string_view matrix_format(std::string_view bytes);

/// The same from the bytes of a file; `name` stands for it in messages. A MATLAB file is read from `name` itself.
std::vector<NamedMatrix> parse_matrices(std::string_view bytes, const std::filesystem::path& name,
                                        std::optional<Index> most = std::nullopt);

/// Where a matrix is: "K.mtx"; or "model.mat:Stiff", the one of that name in a file of several.
struct MatrixPlace {
  std::filesystem::path file;  ///< without the name
  std::string name;            ///< empty: the only one
};
/// A file that exists under the whole of what is written is that file.
MatrixPlace matrix_place(const std::filesystem::path& written);

/// What `read` gives; where it throws Unreadable or TooLarge, no matrix but the reason: of several in a file those that
/// nobody asks for may be anything.
template <class Read>
NamedMatrix matrix_or_reason(const std::string& name, const std::filesystem::path& file, Read&& read) {
  const auto reason = [&](const std::string& what) {
    const std::string prefix = file.string() + ": ";
    return "is not read: " + (what.starts_with(prefix) ? what.substr(prefix.size()) : what);
  };
  try {
    return read();
  } catch (const Unreadable& e) {
    return {name, {}, {}, reason(e.what())};
  } catch (const TooLarge& e) {
    return {name, {}, {}, reason(e.what())};
  }
}
/// A row or column of numbers made the diagonal that it stands for. @throws Unreadable for a matrix that is neither
/// that nor square
void make_square(NamedMatrix& matrix, const std::filesystem::path& file);
/// Rows and columns of zeros added to a list of entries, up to that order.
void extend(NamedMatrix& matrix, Index order);
/// @throws Unreadable where it is no matrix of real numbers
void require_fit(const NamedMatrix& matrix, const std::filesystem::path& file);
/// The one meant; of several the only one of real numbers. @throws Unreadable where there are several and none is
/// chosen, or none of that name, with the names that there are
NamedMatrix chosen_matrix(std::vector<NamedMatrix> all, const MatrixPlace& place);

}  // namespace gyromode
