#include "gyromode/read/toml_text.h"

#include "gyromode/base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace gyromode::io {

namespace {

// Follows a TOML text as far as nesting goes: strings and comments are passed over, dots of keys and brackets are
// counted. Where the text is not TOML the parser stops, and what this finds beyond is of no consequence.
class Nesting {
 public:
  Nesting(std::string_view text, const std::filesystem::path& file) : text_(text), file_(file) {}

  void require_shallow() {
    while (at_ < text_.size()) {
      step();
      if (header_ + open_ + before_equals_ + parts_ > deepest_toml) {
        const auto line_start = text_.rfind('\n', at_ - 1);
        const std::size_t line =
            static_cast<std::size_t>(std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at_ - 1), '\n')) + 1;
        throw Unreadable(
            file_, line, line_start == std::string_view::npos ? at_ : at_ - 1 - line_start,
            fmt::format("keys, tables and arrays are nested here beyond {} levels: a flatter model was expected", deepest_toml));
      }
    }
  }

 private:
  void step() {
    const char c = text_[at_++];
    const bool at_line_start = line_start_;
    if (c != ' ' && c != '\t' && c != '\r') line_start_ = c == '\n';
    switch (c) {
      case '#': at_ = std::min(text_.find('\n', at_), text_.size()); break;
      case '"':
      case '\'': pass_string(c); break;
      case '.': ++parts_; break;
      case '=':
        before_equals_ = parts_ + 1;
        parts_ = 0;
        break;
      case '[':
        if (at_line_start && levels_.empty()) {
          in_header_ = true;
          header_ = 0;
        }
        open();
        break;
      case '{': open(); break;
      case ']':
      case '}': close(); break;
      case ',': next_value(); break;
      case '\n':
        if (levels_.empty()) in_header_ = false;
        next_value();
        break;
      default: break;
    }
  }

  void next_value() { before_equals_ = parts_ = 0; }

  void open() {
    levels_.push_back(before_equals_ + 1);
    open_ += levels_.back();
    next_value();
  }

  void close() {
    if (in_header_) header_ += parts_;
    next_value();
    if (levels_.empty()) return;
    open_ -= levels_.back();
    levels_.pop_back();
    if (in_header_ && levels_.empty()) ++header_;
  }

  // Past a string, basic or literal, of one line or several; one of a line ends with it, closed or not.
  void pass_string(char quote) {
    const std::string triple(3, quote);
    const bool several_lines = text_.substr(at_ - 1, 3) == triple;
    if (several_lines) at_ += 2;
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (!several_lines && c == '\n') return;
      if (c == '\\' && quote == '"') {
        at_ = std::min(at_ + 2, text_.size());
      } else if (c != quote) {
        ++at_;
      } else if (!several_lines) {
        ++at_;
        return;
      } else if (text_.substr(at_, 3) == triple) {
        at_ += 3;
        for (int k = 0; k < 2 && at_ < text_.size() && text_[at_] == quote; ++k) ++at_;  // up to two quotes belong to the content
        return;
      } else {
        ++at_;
      }
    }
  }

  std::string_view text_;
  const std::filesystem::path& file_;
  std::size_t at_ = 0;
  bool line_start_ = true;
  bool in_header_ = false;
  std::size_t header_ = 0;           // levels of the table that the last header opened
  std::vector<std::size_t> levels_;  // of each open bracket, the parts of its key included
  std::size_t open_ = 0;             // their sum
  std::size_t before_equals_ = 0;    // parts of the key before the last '='
  std::size_t parts_ = 0;            // dots since
};

}  // namespace

toml::table parse_toml(std::string_view text, const std::filesystem::path& file) {
  if (text.empty()) throw Unreadable(file, "is empty: a TOML model was expected");
  Nesting(text, file).require_shallow();
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& e) {
    std::string message(e.description());
    for (char& c : message) {
      if (c == '\n' || c == '\r') c = ' ';
    }
    throw Unreadable(file, e.source().begin.line, e.source().begin.column,
                     fmt::format("is not TOML: {}{}", message,
                                 message.find("cannot redefine existing table") == std::string::npos
                                     ? ""
                                     : "; parts of which there may be several are written [[cable]], in double brackets"));
  }
}

}  // namespace gyromode::io
