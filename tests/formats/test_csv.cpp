// CSV in and out: quotes of RFC 4180, blanks, comments, and fields that survive the way out and back.
#include "gyromode/base/error.h"
#include "gyromode/formats/csv.h"

#include <gtest/gtest.h>

namespace gyromode::io {
namespace {

std::vector<std::vector<std::string>> fields(std::string_view text) {
  std::vector<std::vector<std::string>> all;
  for (const CsvRow& row : csv_rows(text, "f.csv")) all.push_back(row.fields);
  return all;
}

TEST(Csv, RowsAndFields) {
  using Rows = std::vector<std::vector<std::string>>;
  EXPECT_EQ(fields("a,b\n1,2\n"), (Rows{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(fields("\xEF\xBB\xBF"
                   "a , b\r\n\r\n# note\r\n 1,\t2"),
            (Rows{{"a", "b"}, {"1", "2"}}));
  EXPECT_EQ(fields("\"a,b\",\"say \"\"x\"\"\",\" c \"\n"), (Rows{{"a,b", "say \"x\"", " c "}}));
  EXPECT_EQ(fields("a,\n,b\n,\n"), (Rows{{"a", ""}, {"", "b"}, {"", ""}}));
  EXPECT_EQ(fields("a;b\n\"x;y\";2,5\n"), (Rows{{"a", "b"}, {"x;y", "2,5"}}));
  EXPECT_EQ(fields("\"a;b\",c\n1;2,3\n"), (Rows{{"a;b", "c"}, {"1;2", "3"}}));
  EXPECT_TRUE(fields("").empty());
}

TEST(Csv, LinesAreThoseOfTheFile) {
  const auto rows = csv_rows("# a\n\nx,1\n# b\ny,2\n", "f.csv");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].line, 3u);
  EXPECT_EQ(rows[1].line, 5u);
}

TEST(Csv, Refusals) {
  const auto message = [](std::string_view text) {
    try {
      csv_rows(text, "f.csv");
    } catch (const Unreadable& e) {
      return std::string(e.what());
    }
    return std::string("read");
  };
  EXPECT_EQ(message("a,b\n\"x,1\n"), "f.csv:2: a quote is not closed on its line");
  EXPECT_EQ(message("\"x\"y,1\n"), "f.csv:1: 'y,1' after a closing quote, where a comma was expected");
}

TEST(Csv, FieldsComeBack) {
  for (const std::string field :
       {"", "x", "a,b", "\"", "say \"x\"", " x", "x ", "\tx", "#x", "x#", "\xEF\xBB\xBFx", "θ1", ",", "a\tb", "a;b"}) {
    const auto rows = csv_rows(csv_field(field) + ",end", "f.csv");
    ASSERT_EQ(rows.size(), 1u) << field;
    EXPECT_EQ(rows[0].fields, (std::vector<std::string>{field, "end"})) << field;
  }
}

}  // namespace
}  // namespace gyromode::io
