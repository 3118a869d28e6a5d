#pragma once

#include "gyromode/base/types.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// Entries of a matrix as a file gives them, in any order, before memory is taken for the whole.
class Entries {
 public:
  Entries(std::filesystem::path file, std::optional<Index> most) : file_(std::move(file)), most_(most) {}

  /// Refuses an order beyond `most`, or one that no dense matrix of so many entries may have (fits_dense()).
  void require_size(Index rows, Index columns, Index entries, std::size_t line = 0) const;
  void add(Index row, Index column, double value) { all_.push_back({row, column, value}); }
  std::size_t count() const { return all_.size(); }
  /// The dense matrix; sign 1, −1: every entry off the diagonal is its mirror image, too; 0: none is. Throws for an
  /// entry given twice.
  Matrix dense(Index rows, Index columns, int sign) const;

  [[noreturn]] void fail(std::size_t line, const std::string& message) const;

 private:
  struct Entry {
    Index row = 0, column = 0;
    double value = 0;
  };
  std::filesystem::path file_;
  std::optional<Index> most_;
  std::vector<Entry> all_;
};

/// A number as Fortran and Nastran write it: "1.5D+03", "2.5+10", "3.". Nothing where it is none, or not finite.
std::optional<double> fortran_number(std::string_view text);

/// (5E16.8), (1P,5D16.8), (16I5): how many numbers a line has, and how wide each is. Nothing for other formats.
struct FortranFormat {
  int count = 1, width = 0;
};
std::optional<FortranFormat> fortran_format(std::string_view text);

}  // namespace gyromode::io
