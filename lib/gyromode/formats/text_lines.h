#pragma once

#include "gyromode/base/error.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace gyromode::io {

/// A text line by line, each split into words. Lines end with LF; the CR of CRLF is a blank.
class Lines {
 public:
  Lines(std::string_view text, const std::filesystem::path& file) : rest_(text), file_(file) {}

  bool next() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    return true;
  }

  // The next line that is neither blank nor a comment.
  bool next_data() {
    while (next()) {
      if (line_.empty() || line_.front() == '%') continue;
      split();
      return true;
    }
    return false;
  }

  void split() {
    count_ = 0;
    for (std::string_view left = line_; !left.empty() && count_ < words_.size(); ++count_) {
      const std::size_t end = std::min(left.find_first_of(blanks), left.size());
      words_[count_] = left.substr(0, end);
      left = trimmed(left.substr(end));
    }
  }

  std::string_view line() const { return line_; }
  std::size_t number() const { return number_; }
  std::span<const std::string_view> words() const { return {words_.data(), count_}; }

  // The words of a line that must have `count` of them.
  std::span<const std::string_view> words(std::size_t count, std::string_view form) const {
    if (count_ < count) fail(fmt::format("line '{}' is too short: {} was expected", shown(line_), form));
    if (count_ > count) fail(fmt::format("'{}' is one too many on its line: {} was expected", shown(words_[count]), form));
    return words();
  }

  [[noreturn]] void fail(const std::string& message) const { throw Unreadable(file_, number_, 0, message); }

 private:
  static constexpr std::string_view blanks = " \t\r";

  static std::string_view trimmed(std::string_view s) {
    s.remove_prefix(std::min(s.find_first_not_of(blanks), s.size()));
    return s.substr(0, s.find_last_not_of(blanks) + 1);
  }

  std::string_view rest_;
  std::filesystem::path file_;
  std::string_view line_;
  std::size_t number_ = 0;
  std::array<std::string_view, 6> words_;  // one more than the longest line, the banner, has
  std::size_t count_ = 0;
};

}  // namespace gyromode::io
