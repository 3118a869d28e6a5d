#pragma once

#include "gyromode/formats/digest.h"
#include "gyromode/base/error.h"
#include "gyromode/base/quantity.h"
#include "gyromode/base/types.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/models/parameters.h"
#include "gyromode/system/laws.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gyromode::io {

/// A table of a TOML file (toml++) that knows where every value stands: each getter returns nothing for a missing key
/// and throws Unreadable with line, column, value and expectation for one of the wrong type or unit.
class TomlTable {
 public:
  /// Parses the text, and its [parameters]; `file` is named in messages, and file names in the text are relative to its
  /// folder.
  TomlTable(std::string_view text, const std::filesystem::path& file);

  /// The [parameters] of the document.
  const std::vector<Parameter>& parameters() const;
  /// The same document with other values of some parameters, SI; those that are formulas of them follow.
  TomlTable with_parameters(const std::vector<ParameterValue>& values) const;

  /// Throws for any key that is not in `keys`, with the nearest one that is.
  void allow_only(std::span<const std::string_view> keys) const;

  std::optional<std::string> text(std::string_view key) const;
  /// The folder that file names are relative to.
  std::filesystem::path folder() const;
  bool has(std::string_view key) const;
  bool is_array(std::string_view key) const;
  bool is_text(std::string_view key) const;
  std::vector<std::string> words(std::string_view key) const;  ///< a string, or an array of them; empty for a missing key
  /// An array of pairs of strings; empty for a missing key.
  std::vector<std::array<std::string, 2>> pairs_of_words(std::string_view key) const;
  /// An array of strings, or the file of labels that a string names, relative to the folder of the model; empty for a
  /// missing key.
  std::vector<std::string> texts_or_file(std::string_view key) const;
  std::vector<double> numbers(std::string_view key) const;      ///< finite; empty for a missing key
  std::optional<double> number(std::string_view key) const;     ///< finite
  std::optional<double> frequency(std::string_view key) const;  ///< rad/s; a number or a string with a unit
  /// A number in SI or a string with a unit of the dimension; finite, unless `infinite`: inf is allowed.
  std::optional<double> quantity(std::string_view key, Dimension dimension, bool infinite = false) const;
  /// `count` of them in an array; `infinite`: inf is allowed. Empty for a missing key.
  std::vector<double> quantities(std::string_view key, Dimension dimension, std::size_t count, bool infinite = false) const;
  /// `count` of them, or as many rows of as many.
  std::optional<Matrix> diagonal_or_matrix(std::string_view key, Dimension dimension, std::size_t count) const;
  std::optional<TomlTable> table(std::string_view key) const;
  /// [key.NAME], in the order of the file, with their names.
  std::vector<std::pair<std::string, TomlTable>> named_tables(std::string_view key) const;
  std::vector<TomlTable> tables(std::string_view key) const;  ///< [[key]], in order; empty for a missing key
  /// A matrix file of any format that is read ("K.mtx", "model.mat:K"), whose bytes are added to the digest; rows of
  /// finite numbers; or a list of them, the diagonal. With the labels of its rows where the file has some.
  std::optional<NamedMatrix> matrix(std::string_view key, Digest& digest) const;

  [[noreturn]] void fail(std::string_view key, const std::string& message) const;  ///< at the value of a key
  [[noreturn]] void fail(const std::string& message) const;                        ///< at the table
  /// Throws LawBroken at the value of a key, or at the table where the key is missing.
  [[noreturn]] void break_law(std::string_view key, const std::string& law) const;

 private:
  struct Content;
  explicit TomlTable(std::shared_ptr<const Content> content);

  std::shared_ptr<const Content> content_;
};

}  // namespace gyromode::io
