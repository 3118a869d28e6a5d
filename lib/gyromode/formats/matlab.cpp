#include "gyromode/formats/matlab.h"

#include "gyromode/formats/entries.h"

#include <fmt/format.h>

#include <matio.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>

namespace gyromode::io {

namespace {

using Variable = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& message) { throw Unreadable(file, message); }

double number(const void* data, matio_types type, std::size_t at) {
  switch (type) {
    case MAT_T_DOUBLE: return static_cast<const double*>(data)[at];
    case MAT_T_SINGLE: return static_cast<double>(static_cast<const float*>(data)[at]);
    case MAT_T_INT64: return static_cast<double>(static_cast<const std::int64_t*>(data)[at]);
    case MAT_T_UINT64: return static_cast<double>(static_cast<const std::uint64_t*>(data)[at]);
    case MAT_T_INT32: return static_cast<const std::int32_t*>(data)[at];
    case MAT_T_UINT32: return static_cast<const std::uint32_t*>(data)[at];
    case MAT_T_INT16: return static_cast<const std::int16_t*>(data)[at];
    case MAT_T_UINT16: return static_cast<const std::uint16_t*>(data)[at];
    case MAT_T_INT8: return static_cast<const std::int8_t*>(data)[at];
    case MAT_T_UINT8: return static_cast<const std::uint8_t*>(data)[at];
    default: return std::nan("");
  }
}

bool numeric(const matvar_t& v) {
  switch (v.class_type) {
    case MAT_C_DOUBLE:
    case MAT_C_SINGLE:
    case MAT_C_INT8:
    case MAT_C_UINT8:
    case MAT_C_INT16:
    case MAT_C_UINT16:
    case MAT_C_INT32:
    case MAT_C_UINT32:
    case MAT_C_INT64:
    case MAT_C_UINT64:
    case MAT_C_SPARSE: return v.rank == 2;
    default: return false;
  }
}

Matrix dense_of(const matvar_t& v, const std::filesystem::path& file) {
  const auto rows = static_cast<Index>(v.dims[0]), columns = static_cast<Index>(v.dims[1]);
  Matrix a(rows, columns);
  for (Index j = 0; j < columns; ++j) {
    for (Index i = 0; i < rows; ++i) {
      a(i, j) = number(v.data, v.data_type, static_cast<std::size_t>(j * rows + i));
      if (!std::isfinite(a(i, j))) fail(file, fmt::format("variable '{}': entry ({},{}) is not finite", v.name, i + 1, j + 1));
    }
  }
  return a;
}

Matrix sparse_of(const matvar_t& v, const std::filesystem::path& file, Entries entries) {
  const auto& s = *static_cast<const mat_sparse_t*>(v.data);
  const auto rows = static_cast<Index>(v.dims[0]), columns = static_cast<Index>(v.dims[1]);
  if (static_cast<Index>(s.njc) != columns + 1)
    fail(file, fmt::format("variable '{}': the columns of the sparse matrix are damaged", v.name));
  for (Index j = 0; j < columns; ++j) {
    for (auto k = static_cast<std::size_t>(s.jc[j]); k < static_cast<std::size_t>(s.jc[j + 1]); ++k) {
      if (k >= static_cast<std::size_t>(s.ndata) || k >= static_cast<std::size_t>(s.nir) || static_cast<Index>(s.ir[k]) >= rows)
        fail(file, fmt::format("variable '{}': the rows of the sparse matrix are damaged", v.name));
      const double value = number(s.data, v.data_type, k);
      if (!std::isfinite(value)) fail(file, fmt::format("variable '{}': an entry of column {} is not finite", v.name, j + 1));
      entries.add(static_cast<Index>(s.ir[k]), j, value);
    }
  }
  return entries.dense(rows, columns, 0);
}

// libmatio reads what is missing at the end of a file as zeros: a file of version 5 is walked by the lengths of its
// elements before.
void require_whole(std::string_view bytes, const std::filesystem::path& file) {
  constexpr std::size_t header = 128;
  if (!bytes.starts_with("MATLAB 5.0")) return;
  const auto damaged = [&] { fail(file, "ends within a variable: the file is damaged or was not copied whole"); };
  if (bytes.size() < header) damaged();
  const bool big_endian = bytes[126] == 'M';
  for (std::size_t at = header; at < bytes.size();) {
    if (bytes.size() - at < 8) damaged();
    std::size_t length = 0;
    for (std::size_t k = 0; k < 4; ++k) length = 256 * length + static_cast<unsigned char>(bytes[at + 4 + (big_endian ? k : 3 - k)]);
    at += 8;
    if (length > bytes.size() - at) damaged();
    at += length;
  }
}

NamedMatrix matrix_of(mat_t* mat, matvar_t& v, const std::filesystem::path& file, std::optional<Index> most) {
  const auto rows = static_cast<Index>(v.dims[0]), columns = static_cast<Index>(v.dims[1]);
  if (v.isComplex) return {v.name, {}, {}, "is complex"};
  Entries entries(file, most);
  if (v.class_type != MAT_C_SPARSE) entries.require_size(rows, columns, rows * columns);
  if (Mat_VarReadDataAll(mat, &v) != 0 || !v.data) fail(file, fmt::format("variable '{}' cannot be read", v.name));
  if (v.class_type != MAT_C_SPARSE) return {v.name, dense_of(v, file), {}};
  entries.require_size(rows, columns, static_cast<Index>(static_cast<const mat_sparse_t*>(v.data)->ndata));
  return {v.name, sparse_of(v, file, std::move(entries)), {}};
}

}  // namespace

bool is_matlab(std::string_view bytes) {
  if (bytes.starts_with("MATLAB 5.0 MAT-file") || bytes.starts_with("MATLAB 7.3 MAT-file") || bytes.starts_with("\x89HDF\r\n\x1a\n"))
    return true;
  if (bytes.size() < 20) return false;  // v4: type MOPT, rows, columns, imaginary, length of the name
  const auto number_at = [&](std::size_t k, bool swapped) {
    unsigned char b[4];
    std::memcpy(b, bytes.data() + 4 * k, 4);
    return swapped ? std::uint32_t{b[0]} << 24 | std::uint32_t{b[1]} << 16 | std::uint32_t{b[2]} << 8 | b[3]
                   : std::uint32_t{b[3]} << 24 | std::uint32_t{b[2]} << 16 | std::uint32_t{b[1]} << 8 | b[0];
  };
  for (const bool swapped : {false, true}) {
    const std::uint32_t type = number_at(0, swapped), length = number_at(4, swapped);
    if (type < 5000 && type / 1000 == (swapped ? 1U : 0U) && type / 10 % 10 <= 5 && type % 10 <= 2 && number_at(3, swapped) <= 1 &&
        length >= 2 && length <= 64 && bytes.size() >= 20 + length && bytes[20 + length - 1] == '\0' && number_at(1, swapped) < (1U << 20))
      return true;
  }
  return false;
}

std::vector<NamedMatrix> read_matlab(std::string_view bytes, const std::filesystem::path& file, std::optional<Index> most) {
  require_whole(bytes, file);
  Mat_LogInit(nullptr);
  const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_Open(file.string().c_str(), MAT_ACC_RDONLY), Mat_Close);
  if (!mat) fail(file, "cannot be read as a MATLAB file");
  std::vector<NamedMatrix> all;
  for (;;) {
    Variable info(Mat_VarReadNextInfo(mat.get()), Mat_VarFree);
    if (!info) break;
    if (!info->name || !numeric(*info) || info->dims[0] == 0 || info->dims[1] == 0) continue;
    all.push_back(matrix_or_reason(info->name, file, [&] { return matrix_of(mat.get(), *info, file, most); }));
  }
  if (all.empty()) fail(file, "holds no matrix of real numbers");
  return all;
}

void write_matlab(const std::filesystem::path& file, const std::vector<NamedMatrix>& matrices) {
  const std::unique_ptr<mat_t, int (*)(mat_t*)> mat(Mat_CreateVer(file.string().c_str(), nullptr, MAT_FT_MAT5), Mat_Close);
  if (!mat) fail(file, "cannot be written");
  for (const NamedMatrix& m : matrices) {
    std::size_t dims[2] = {static_cast<std::size_t>(m.matrix.rows()), static_cast<std::size_t>(m.matrix.cols())};
    const Variable v(
        Mat_VarCreate(m.name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, const_cast<double*>(m.matrix.data()), MAT_F_DONT_COPY_DATA),
        Mat_VarFree);
    if (!v || Mat_VarWrite(mat.get(), v.get(), MAT_COMPRESSION_NONE) != 0)
      fail(file, fmt::format("variable '{}' cannot be written", m.name));
  }
}

}  // namespace gyromode::io
