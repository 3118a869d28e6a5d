#include "gyromode/read/initial_state.h"

#include "gyromode/base/labels.h"
#include "gyromode/formats/csv.h"
#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/base/number.h"
#include "gyromode/formats/text_file.h"

#include <fmt/format.h>

#include <algorithm>

namespace gyromode::io {

namespace {

double number_in(const CsvRow& row, std::size_t column, std::string_view what, const std::filesystem::path& file) {
  if (column >= row.fields.size()) throw Unreadable(file, row.line, 0, fmt::format("no {} on this line: label,q,qdot was expected", what));
  const std::string& field = row.fields[column];
  const Parsed p = parse_real(field);
  if (p.outcome == Parsed::ok) return p.value;
  throw Unreadable(file, row.line, 0,
                   fmt::format("{} '{}' is {}: a finite number was expected{}", what, shown(field),
                               p.outcome == Parsed::not_finite ? "not finite" : "no number",
                               field.find(',') == std::string::npos ? "" : ", with a decimal point"));
}

// A label as it is, unless a terminal would obey it.
std::string readable(const std::string& label) { return has_control_character(label) ? shown(label) : label; }

struct Columns {
  std::size_t label, q, qdot;
};

Columns columns_of(const CsvRow& heading, const std::filesystem::path& file) {
  const auto find = [&](std::string_view name) {
    const auto at = std::find(heading.fields.begin(), heading.fields.end(), name);
    if (at == heading.fields.end())
      throw Unreadable(file, heading.line, 0, fmt::format("no column '{}': the heading label,q,qdot was expected", name));
    if (std::count(heading.fields.begin(), heading.fields.end(), name) > 1)
      throw Unreadable(file, heading.line, 0, fmt::format("column '{}' stands twice in the heading", name));
    return static_cast<std::size_t>(at - heading.fields.begin());
  };
  return {find("label"), find("q"), find("qdot")};
}

}  // namespace

State parse_initial_state(std::string_view text, const std::filesystem::path& file, const Labels& labels) {
  const std::vector<CsvRow> rows = csv_rows(text, file);
  if (rows.empty()) throw Unreadable(file, "empty, where the heading label,q,qdot and a line a coordinate were expected");
  const Columns columns = columns_of(rows.front(), file);
  const Index n = static_cast<Index>(labels.size());
  State state{Vector::Zero(n), Vector::Zero(n)};
  std::vector<std::size_t> given(labels.size(), 0);  // the line, 0 for none
  const std::vector<std::string_view> known(labels.begin(), labels.end());
  for (std::size_t k = 1; k < rows.size(); ++k) {
    const CsvRow& row = rows[k];
    if (row.fields.size() > rows.front().fields.size()) {
      throw Unreadable(
          file, row.line, 0,
          fmt::format("{} fields under a heading of {}: decimals have a point", row.fields.size(), rows.front().fields.size()));
    }
    if (columns.label >= row.fields.size()) throw Unreadable(file, row.line, 0, "no label on this line: label,q,qdot was expected");
    const std::string& label = row.fields[columns.label];
    const auto at = std::find(labels.begin(), labels.end(), label);
    if (at == labels.end())
      throw Unreadable(file, row.line, 0, fmt::format("'{}' is no coordinate of the model{}", readable(label), suggestion(label, known)));
    const auto i = static_cast<std::size_t>(at - labels.begin());
    if (given[i] > 0)
      throw Unreadable(file, row.line, 0, fmt::format("'{}' is given a second time (first on line {})", readable(label), given[i]));
    given[i] = row.line;
    state.q(static_cast<Index>(i)) = number_in(row, columns.q, "q", file);
    state.qdot(static_cast<Index>(i)) = number_in(row, columns.qdot, "qdot", file);
  }
  const auto missing = std::find(given.begin(), given.end(), 0u);
  if (missing != given.end()) {
    throw Unreadable(
        file, fmt::format("{} of {} coordinates are given, '{}' is not: a line a coordinate was expected, with 0,0 for what is at rest",
                          rows.size() - 1, n, labels[static_cast<std::size_t>(missing - given.begin())]));
  }
  return state;
}

State read_initial_state(const std::filesystem::path& file, const Labels& labels) {
  return parse_initial_state(read_text(file, "CSV (label,q,qdot)"), file, labels);
}

Vector parse_times(std::string_view text, const std::filesystem::path& file) {
  std::vector<CsvRow> rows = csv_rows(text, file);
  if (!rows.empty() && rows.front().fields.front() == "t") rows.erase(rows.begin());
  if (rows.empty()) throw Unreadable(file, "no times: one a line was expected");
  Vector times(static_cast<Index>(rows.size()));
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double t = number_in(rows[k], 0, "time", file);
    const auto i = static_cast<Index>(k);
    if (!(t >= 0)) throw Unreadable(file, rows[k].line, 0, fmt::format("time {:.17g}: t ≥ 0 was expected", t));
    if (i > 0 && !(t > times(i - 1)))
      throw Unreadable(file, rows[k].line, 0, fmt::format("time {:.17g} after {:.17g}: increasing times were expected", t, times(i - 1)));
    times(i) = t;
  }
  return times;
}

Vector read_times(const std::filesystem::path& file) { return parse_times(read_text(file, "times"), file); }

}  // namespace gyromode::io
