// Format: NumPy Enhancement Proposal 1, "A Simple File Format for NumPy Arrays", and numpy.lib.format.
#include "gyromode/formats/entries.h"
#include "gyromode/formats/numpy.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace gyromode::io {

namespace {

constexpr std::string_view magic{"\x93NUMPY", 6};

[[noreturn]] void fail(const std::filesystem::path& name, const std::string& message) { throw Unreadable(name, message); }

// The value of a key of the header's dictionary, up to the comma or brace that ends it.
std::string_view value_of(std::string_view header, std::string_view key, const std::filesystem::path& name) {
  const std::size_t at = header.find(fmt::format("'{}'", key));
  const std::size_t colon = at == std::string_view::npos ? at : header.find(':', at);
  if (colon == std::string_view::npos) fail(name, fmt::format("the header of the NumPy array has no '{}'", key));
  std::string_view rest = header.substr(colon + 1);
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  const std::size_t end = !rest.empty() && rest.front() == '(' ? rest.find(')') : rest.find_first_of(",}");
  return rest.substr(0, end == std::string_view::npos ? end : end + (rest[end] == ')'));
}

struct Header {
  char endian = '<', kind = 'O';  // f, i, u, b, c, …; O: records or objects
  std::size_t size = 8;           // bytes
  std::size_t dimensions = 2;
  bool column_major = false;
  Index rows = 0, columns = 1;
  std::string_view content;
};

std::vector<Index> shape_of(std::string_view text, const std::filesystem::path& name) {
  std::vector<Index> shape;
  Index value = 0;
  bool digits = false;
  for (const char c : text) {
    if (c >= '0' && c <= '9') {
      value = 10 * value + (c - '0');
      digits = true;
      if (value > (Index{1} << 40)) fail(name, "the NumPy array is too large");
    } else if (digits) {
      shape.push_back(value);
      value = 0;
      digits = false;
    }
  }
  return shape;
}

Header header_of(std::string_view bytes, const std::filesystem::path& name) {
  if (bytes.size() < 12) fail(name, "the NumPy array ends within its header");
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
  const std::size_t version = byte(6), first = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? byte(8) + 256 * byte(9) : byte(8) + 256 * (byte(9) + 256 * (byte(10) + 256 * byte(11)));
  if (version < 1 || version > 3 || length > bytes.size() - first) fail(name, "the header of the NumPy array is damaged");
  const std::string_view text = bytes.substr(first, length);
  Header h;
  h.content = bytes.substr(first + length);
  const std::string_view type = value_of(text, "descr", name);
  if (type.size() < 5 || type.front() != '\'') return h;
  h.endian = type[1];
  h.kind = type[2];
  h.size = 0;
  for (const char c : type.substr(3, type.size() - 4)) {
    if (c < '0' || c > '9' || h.size > 99) {  // of dates and the like
      h.kind = 'V';
      return h;
    }
    h.size = 10 * h.size + static_cast<std::size_t>(c - '0');
  }
  h.column_major = value_of(text, "fortran_order", name).starts_with("True");
  const std::vector<Index> shape = shape_of(value_of(text, "shape", name), name);
  h.dimensions = shape.size();
  h.rows = shape.empty() ? 1 : shape[0];
  h.columns = shape.size() == 2 ? shape[1] : 1;
  return h;
}

template <class T>
T read_as(const char* from, bool swapped) {
  unsigned char bytes[sizeof(T)];
  std::memcpy(bytes, from, sizeof(T));
  if (swapped) {
    for (std::size_t k = 0; k < sizeof(T) / 2; ++k) std::swap(bytes[k], bytes[sizeof(T) - 1 - k]);
  }
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

double number(const Header& h, const char* at, bool swapped) {
  switch (h.kind) {
    case 'f': return h.size == 8 ? read_as<double>(at, swapped) : static_cast<double>(read_as<float>(at, swapped));
    case 'i':
      return h.size == 8   ? static_cast<double>(read_as<std::int64_t>(at, swapped))
             : h.size == 4 ? read_as<std::int32_t>(at, swapped)
             : h.size == 2 ? read_as<std::int16_t>(at, swapped)
                           : static_cast<signed char>(*at);
    default:
      return h.size == 8   ? static_cast<double>(read_as<std::uint64_t>(at, swapped))
             : h.size == 4 ? read_as<std::uint32_t>(at, swapped)
             : h.size == 2 ? read_as<std::uint16_t>(at, swapped)
                           : static_cast<unsigned char>(*at);
  }
}

bool known_type(const Header& h) {
  if (h.kind == 'f') return h.size == 4 || h.size == 8;
  if (h.kind == 'b') return h.size == 1;
  return (h.kind == 'i' || h.kind == 'u') && (h.size == 1 || h.size == 2 || h.size == 4 || h.size == 8);
}

std::string why_unfit(const Header& h) {
  if (h.kind == 'O') return "holds records or objects";
  if (h.kind == 'c') return "is complex";
  if (!known_type(h)) return fmt::format("is of type '{}{}'", h.kind, h.size);
  return h.dimensions > 2 ? fmt::format("has {} dimensions", h.dimensions) : "";
}

}  // namespace

bool is_npy(std::string_view bytes) { return bytes.starts_with(magic); }

Matrix parse_npy(std::string_view bytes, const std::filesystem::path& name, std::optional<Index> most, bool may_be_empty) {
  if (!is_npy(bytes)) fail(name, "is no NumPy array");
  const Header h = header_of(bytes, name);
  if (const std::string why = why_unfit(h); !why.empty())
    fail(name, fmt::format("the NumPy array {}: a matrix of real numbers was expected", why));
  const auto available = static_cast<Index>(h.content.size() / h.size);
  if (h.rows > 0 && h.columns > available / h.rows)
    fail(name, fmt::format("the NumPy array ends after {} of {} × {} numbers", available, h.rows, h.columns));
  if (may_be_empty && (h.rows == 0 || h.columns == 0)) return Matrix(h.rows, h.columns);
  Entries(name, most).require_size(h.rows, h.columns, h.rows * h.columns);
  if (static_cast<std::size_t>(h.rows * h.columns) * h.size != h.content.size())
    fail(name, fmt::format("the NumPy array of {} × {} numbers is followed by {} bytes more: one array a file was expected, or .npz",
                           h.rows, h.columns, h.content.size() - static_cast<std::size_t>(h.rows * h.columns) * h.size));
  const bool swapped = (h.endian == '>') != (std::endian::native == std::endian::big) && h.size > 1;
  Matrix a(h.rows, h.columns);
  for (Index i = 0; i < h.rows; ++i) {
    for (Index j = 0; j < h.columns; ++j) {
      const Index at = h.column_major ? j * h.rows + i : i * h.columns + j;
      a(i, j) = number(h, h.content.data() + static_cast<std::size_t>(at) * h.size, swapped);
      if (!std::isfinite(a(i, j))) fail(name, fmt::format("entry ({},{}) is not finite", i + 1, j + 1));
    }
  }
  return a;
}

std::string unfit_npy(std::string_view bytes, const std::filesystem::path& name) { return why_unfit(header_of(bytes, name)); }

std::string format_npy(const Matrix& a) {
  static_assert(std::endian::native == std::endian::little);
  std::string header = fmt::format("{{'descr': '<f8', 'fortran_order': True, 'shape': ({}, {}), }}", a.rows(), a.cols());
  while ((10 + header.size() + 1) % 64 != 0) header += ' ';
  header += '\n';
  std::string bytes(magic);
  bytes += {'\x01', '\x00', static_cast<char>(header.size() % 256), static_cast<char>(header.size() / 256)};
  bytes += header;
  bytes.append(reinterpret_cast<const char*>(a.data()), static_cast<std::size_t>(a.size()) * sizeof(double));
  return bytes;
}

}  // namespace gyromode::io
