// Format: MSC Nastran Quick Reference Guide, bulk data entry DMIG.
#include "gyromode/formats/entries.h"
#include "gyromode/formats/nastran.h"
#include "gyromode/formats/text_file.h"

#include "gyromode/base/number.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>

namespace gyromode::io {

namespace {

using Dof = std::pair<Index, Index>;  // grid point, component

std::string_view trimmed(std::string_view s) {
  while (!s.empty() && (s.front() == ' ' || s.front() == '\t')) s.remove_prefix(1);
  while (!s.empty() && (s.back() == ' ' || s.back() == '\t' || s.back() == '\r')) s.remove_suffix(1);
  return s;
}

bool starts_entry(std::string_view line) {
  if (line.size() < 4) return false;
  for (std::size_t k = 0; k < 4; ++k) {
    if (std::toupper(static_cast<unsigned char>(line[k])) != "DMIG"[k]) return false;
  }
  return line.size() == 4 || line[4] == ' ' || line[4] == '*' || line[4] == ',' || line[4] == '\t';
}

// One entry of the bulk data: its fields after the first, those of continuations behind.
struct Card {
  std::size_t line = 0;
  std::vector<std::string_view> fields;

  std::string_view field(std::size_t k) const { return k < fields.size() ? fields[k] : std::string_view(); }
};

void add_fields(std::string_view line, Card& card) {
  if (line.find(',') != std::string_view::npos) {  // free field: a mark, eight fields
    std::size_t count = 0;
    for (std::size_t at = line.find(','); at != std::string_view::npos && count < 8; ++count) {
      const std::size_t next = line.find(',', at + 1);
      card.fields.push_back(trimmed(line.substr(at + 1, next == std::string_view::npos ? next : next - at - 1)));
      at = next;
    }
    for (; count < 8; ++count) card.fields.emplace_back();
    return;
  }
  // Free field parted by blanks, as APDL's *DMAT reads it: the name does not wait for column 9, and terms have no
  // second part of the value.
  if (starts_entry(line) && line.size() > 5 && line[4] == ' ' && trimmed(line.substr(5, 3)) != "") {
    std::vector<std::string_view> words;
    for (std::string_view rest = trimmed(line.substr(4)); !rest.empty(); rest = trimmed(rest)) {
      const std::size_t end = std::min(rest.find(' '), rest.size());
      words.push_back(rest.substr(0, end));
      rest.remove_prefix(end);
    }
    const bool header = words.size() > 1 && words[1] == "0";
    for (std::size_t k = 0; k < words.size(); ++k) {
      if (!header && k == 3) card.fields.emplace_back();
      card.fields.push_back(words[k]);
      if (!header && k >= 3 && (k - 3) % 3 == 2) card.fields.emplace_back();
    }
    return;
  }
  const bool large = line.substr(0, 8).find('*') != std::string_view::npos;
  const std::size_t width = large ? 16 : 8, fields = large ? 4 : 8;
  for (std::size_t k = 0; k < fields; ++k) {
    const std::size_t first = 8 + k * width;
    card.fields.push_back(first < line.size() ? trimmed(line.substr(first, width)) : std::string_view());
  }
}

std::vector<Card> cards_of(std::string_view text) {
  std::vector<Card> cards;
  bool within = false;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (const std::size_t comment = line.find('$'); comment != std::string_view::npos) line = line.substr(0, comment);
    if (trimmed(line).empty()) continue;
    if (starts_entry(line)) {
      cards.push_back({number, {}});
      within = true;
    } else if (line.front() != ' ' && line.front() != '+' && line.front() != '*' && line.front() != ',') {
      within = false;  // another entry of the bulk data
    }
    if (within) add_fields(line, cards.back());
  }
  return cards;
}

struct Header {
  int form = 6;
  std::size_t line = 0;

  bool rectangular() const { return form == 2 || form == 9; }  // columns of 9 are numbers, and no degrees of freedom
};

struct Term {
  Dof row, column;
  double value = 0;
  std::size_t line = 0;
};

class Reader {
 public:
  Reader(const std::filesystem::path& name, std::optional<Index> most) : name_(name), most_(most) {}

  void read(const Card& card) {
    const std::string matrix(card.field(0));
    if (complex_.count(matrix)) return;
    if (matrix.empty()) fail(card, "the name of the matrix is missing");
    if (card.field(1) == "0")
      header(card, matrix);
    else
      column(card, matrix);
  }

  std::vector<NamedMatrix> matrices() const {
    std::vector<NamedMatrix> all;
    for (const std::string& matrix : order_) {
      const auto& terms = terms_.at(matrix);
      if (headers_.at(matrix).rectangular()) {
        all.push_back({matrix, {}, {}, "is rectangular"});
        continue;
      }
      if (terms.empty()) {
        all.push_back({matrix, {}, {}, "has no entries"});
        continue;
      }
      std::set<Dof> dofs;
      for (const Term& t : terms) dofs.insert({t.row, t.column});
      std::map<Dof, Index> place;
      Labels labels;
      for (const Dof& d : dofs) {
        place[d] = static_cast<Index>(labels.size());
        labels.push_back(d.second == 0 ? fmt::format("{}", d.first) : fmt::format("{}.{}", d.first, d.second));
      }
      const auto order = static_cast<Index>(labels.size());
      Entries entries(name_, most_);
      entries.require_size(order, order, static_cast<Index>(terms.size()), headers_.at(matrix).line);
      for (const Term& t : terms) entries.add(place.at(t.row), place.at(t.column), t.value);
      all.push_back({matrix, entries.dense(order, order, headers_.at(matrix).form == 6 ? 1 : 0), labels});
    }
    for (const std::string& matrix : complex_) all.push_back({matrix, {}, {}, "is complex"});
    return all;
  }

 private:
  [[noreturn]] void fail(const Card& card, const std::string& message) const { throw Unreadable(name_, card.line, 0, "DMIG: " + message); }

  void header(const Card& card, const std::string& matrix) {
    if (headers_.count(matrix)) fail(card, fmt::format("'{}' has two headers", shown(matrix)));
    const auto form = whole_number(card.field(2)), type = whole_number(card.field(3));
    if (!form || (*form != 1 && *form != 2 && *form != 6 && *form != 9))
      fail(card, fmt::format("form '{}' of '{}': 1 (square), 2 or 9 (rectangular) or 6 (symmetric) was expected", shown(card.field(2)),
                             shown(matrix)));
    if (!type || *type < 1 || *type > 4)
      fail(card, fmt::format("type '{}' of '{}': 1 or 2 (real) was expected", shown(card.field(3)), shown(matrix)));
    if (*type > 2) {
      complex_.insert(matrix);
      return;
    }
    headers_[matrix] = {static_cast<int>(*form), card.line};
    order_.push_back(matrix);
    terms_[matrix];
  }

  Index whole(const Card& card, std::string_view text, std::string_view what) const {
    if (text.empty()) return 0;
    const auto value = whole_number(text);
    if (!value || *value < 0 || *value > 999'999'999) fail(card, fmt::format("{} is '{}': a whole number was expected", what, shown(text)));
    return *value;
  }

  void column(const Card& card, const std::string& matrix) {
    const auto header = headers_.find(matrix);
    if (header == headers_.end())
      fail(card, fmt::format("'{}' has no header before its columns: DMIG,{},0,… was expected", shown(matrix), shown(matrix)));
    const Dof at{whole(card, card.field(1), "a grid point"), whole(card, card.field(2), "a component")};
    for (std::size_t k = 4; k < card.fields.size(); k += 4) {
      if (card.field(k).empty() && card.field(k + 2).empty()) continue;
      const Dof row{whole(card, card.field(k), "a grid point"), whole(card, card.field(k + 1), "a component")};
      const auto value = fortran_number(card.field(k + 2));
      if (row.first == 0 || !value)
        fail(card, fmt::format("the term '{} {} {}' of '{}': grid point, component and value were expected", shown(card.field(k)),
                               shown(card.field(k + 1)), shown(card.field(k + 2)), shown(matrix)));
      Term t{row, at, *value, card.line};
      if (header->second.form == 6 && t.row < t.column) std::swap(t.row, t.column);
      terms_[matrix].push_back(t);
    }
  }

  const std::filesystem::path& name_;
  std::optional<Index> most_;
  std::map<std::string, Header> headers_;
  std::map<std::string, std::vector<Term>> terms_;
  std::vector<std::string> order_;
  std::set<std::string> complex_;
};

}  // namespace

// Other entries of the bulk data may stand before, and case control.
bool is_dmig(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    if (starts_entry(line)) return true;
    const bool of_a_deck = trimmed(line).empty() || std::isalpha(static_cast<unsigned char>(line.front())) ||
                           std::string_view("$+* ,").find(line.front()) != std::string_view::npos;
    if (!of_a_deck) return false;
    if (end == std::string_view::npos) return false;
    text.remove_prefix(end + 1);
  }
  return false;
}

std::vector<NamedMatrix> parse_dmig(std::string_view text, const std::filesystem::path& name, std::optional<Index> most) {
  Reader reader(name, most);
  for (const Card& card : cards_of(text)) reader.read(card);
  return reader.matrices();
}

}  // namespace gyromode::io
