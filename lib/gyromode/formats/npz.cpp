// NumPy archives by libzip; scipy.sparse.save_npz stores a matrix as arrays format, shape, data and indices, indptr
// (csr, csc), row, col (coo).
#include "gyromode/formats/entries.h"
#include "gyromode/formats/numpy.h"

#include <fmt/format.h>

#include <zip.h>

#include <cmath>
#include <map>
#include <memory>

namespace gyromode::io {

namespace {

[[noreturn]] void fail(const std::filesystem::path& name, const std::string& message) { throw Unreadable(name, message); }

// name of the array → bytes of its .npy
std::map<std::string, std::string> arrays_of(std::string_view bytes, const std::filesystem::path& name) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (!source) fail(name, "cannot be read as an archive");
  zip_t* opened = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (!opened) {
    zip_source_free(source);
    fail(name, fmt::format("is a damaged archive of NumPy arrays ({})", zip_error_strerror(&error)));
  }
  const std::unique_ptr<zip_t, void (*)(zip_t*)> archive(opened, zip_discard);
  constexpr zip_uint64_t most_bytes = zip_uint64_t{1} << 32, most_arrays = 1000;
  std::map<std::string, std::string> arrays;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count < 0 || static_cast<zip_uint64_t>(count) > most_arrays) fail(name, "holds too many arrays");
  for (zip_uint64_t k = 0; k < static_cast<zip_uint64_t>(count); ++k) {
    zip_stat_t stat;
    if (zip_stat_index(archive.get(), k, 0, &stat) != 0 || !(stat.valid & ZIP_STAT_NAME) || !(stat.valid & ZIP_STAT_SIZE)) continue;
    std::string entry = stat.name;
    if (!entry.ends_with(".npy")) continue;
    entry.resize(entry.size() - 4);
    if (stat.size > most_bytes) fail(name, fmt::format("array '{}' is too large", entry));
    const std::unique_ptr<zip_file_t, int (*)(zip_file_t*)> file(zip_fopen_index(archive.get(), k, 0), zip_fclose);
    if (!file) fail(name, fmt::format("array '{}' cannot be read: {}", entry, zip_strerror(archive.get())));
    std::string content;
    char chunk[1 << 15];
    for (zip_int64_t got = 0; (got = zip_fread(file.get(), chunk, sizeof chunk)) != 0;) {
      if (got < 0) fail(name, fmt::format("array '{}' is damaged: {}", entry, zip_file_strerror(file.get())));
      content.append(chunk, static_cast<std::size_t>(got));
      if (content.size() > stat.size) fail(name, fmt::format("array '{}' is longer than its entry says", entry));
    }
    arrays[entry] = std::move(content);
  }
  return arrays;
}

class Sparse {
 public:
  Sparse(const std::map<std::string, std::string>& arrays, const std::filesystem::path& name, std::optional<Index> most)
      : arrays_(arrays), name_(name), entries_(name, most) {}

  Matrix dense() {
    const std::string& format = arrays_.at("format");
    const bool by_rows = contains(format, "csr"), by_columns = contains(format, "csc");
    if (!by_rows && !by_columns && !contains(format, "coo"))
      fail(name_, "the sparse matrix is of a format that is not read: csr, csc or coo was expected (A.tocsr() before save_npz)");
    const Matrix shape = array("shape");
    if (shape.size() != 2) fail(name_, "the sparse matrix has no shape of two numbers");
    rows_ = whole(shape(0), Index{1} << 31);
    columns_ = whole(shape(1), Index{1} << 31);
    data_ = array("data");
    entries_.require_size(rows_, columns_, std::max<Index>(data_.size(), 1));
    if (by_rows || by_columns)
      compressed(by_rows);
    else
      triplets();
    return entries_.dense(rows_, columns_, 0);
  }

 private:
  // As text, or as UTF-32.
  static bool contains(const std::string& bytes, std::string_view word) {
    std::string wide;
    for (const char c : word) wide += {c, '\0', '\0', '\0'};
    return bytes.find(word, 80) != std::string::npos || bytes.find(wide.substr(0, 9), 80) != std::string::npos;
  }
  Matrix array(const std::string& key) const {
    const auto at = arrays_.find(key);
    if (at == arrays_.end()) fail(name_, fmt::format("the sparse matrix has no array '{}'", key));
    return parse_npy(at->second, name_, std::nullopt, true);
  }
  Index whole(double value, Index below) const {
    if (!(value >= 0 && value < static_cast<double>(below)) || value != std::floor(value))
      fail(name_, fmt::format("the sparse matrix has an index {} where one from 0 to {} was expected", value, below - 1));
    return static_cast<Index>(value);
  }
  void compressed(bool by_rows) {
    const Matrix pointers = array("indptr"), indices = array("indices");
    const Index major = by_rows ? rows_ : columns_, minor = by_rows ? columns_ : rows_;
    if (pointers.size() != major + 1 || indices.size() < data_.size()) fail(name_, "the arrays of the sparse matrix do not fit each other");
    Index at = whole(pointers(0), data_.size() + 1);
    for (Index i = 0; i < major; ++i) {
      const Index end = whole(pointers(i + 1), data_.size() + 1);
      for (; at < end; ++at) {
        const Index j = whole(indices(at), minor);
        entries_.add(by_rows ? i : j, by_rows ? j : i, data_(at));
      }
    }
  }
  void triplets() {
    const Matrix row = array("row"), column = array("col");
    if (row.size() != data_.size() || column.size() != data_.size()) fail(name_, "the arrays of the sparse matrix do not fit each other");
    for (Index k = 0; k < data_.size(); ++k) entries_.add(whole(row(k), rows_), whole(column(k), columns_), data_(k));
  }

  const std::map<std::string, std::string>& arrays_;
  const std::filesystem::path& name_;
  Entries entries_;
  Index rows_ = 0, columns_ = 0;
  Matrix data_;
};

}  // namespace

bool is_npz(std::string_view bytes) { return bytes.starts_with(std::string_view("PK\x03\x04", 4)); }

std::vector<NamedMatrix> parse_npz(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most) {
  const auto arrays = arrays_of(bytes, name);
  if (arrays.count("format") && arrays.count("shape")) return {{name.stem().string(), Sparse(arrays, name, most).dense()}};
  std::vector<NamedMatrix> all;
  for (const auto& [key, content] : arrays) {
    all.push_back(matrix_or_reason(key, name, [&, &array = content, &entry = key]() -> NamedMatrix {
      const std::string unfit = is_npy(array) ? unfit_npy(array, name) : "is no NumPy array";
      return {entry, unfit.empty() ? parse_npy(array, name, most) : Matrix(), {}, unfit};
    }));
  }
  if (all.empty()) fail(name, "is an archive without NumPy arrays: .npz was expected");
  return all;
}

std::string format_npz(const std::vector<NamedMatrix>& matrices) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_source_keep(target);
  zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, &error);
  std::vector<std::string> contents;  // until the archive is closed
  contents.reserve(matrices.size());
  for (const NamedMatrix& m : matrices) {
    contents.push_back(format_npy(m.matrix));
    zip_source_t* one = zip_source_buffer(archive, contents.back().data(), contents.back().size(), 0);
    zip_file_add(archive, (m.name + ".npy").c_str(), one, ZIP_FL_ENC_UTF_8);
  }
  std::string bytes;
  if (zip_close(archive) == 0 && zip_source_open(target) == 0) {
    char chunk[1 << 15];
    for (zip_int64_t got = 0; (got = zip_source_read(target, chunk, sizeof chunk)) > 0;) bytes.append(chunk, static_cast<std::size_t>(got));
    zip_source_close(target);
  }
  zip_source_free(target);
  return bytes;
}

}  // namespace gyromode::io
