#include "gyromode/base/error.h"
#include "gyromode/formats/matrix_market.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#if defined(__has_feature)
#define GYROMODE_HAS_FEATURE(x) __has_feature(x)
#else
#define GYROMODE_HAS_FEATURE(x) 0
#endif

namespace gyromode::io {
namespace {

#if defined(__SANITIZE_ADDRESS__) || GYROMODE_HAS_FEATURE(address_sanitizer)
constexpr bool address_sanitizer = true;
#else
constexpr bool address_sanitizer = false;
#endif

namespace fs = std::filesystem;

Matrix parse(std::string_view text) { return parse_matrix_market(text, "K.mtx"); }

std::string parse_error(std::string_view text) {
  try {
    parse(text);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "(accepted)";
}

std::string read_error(const fs::path& file) {
  try {
    read_matrix_market(file);
  } catch (const Unreadable& error) {
    return error.what();
  }
  return "(accepted)";
}

std::string format_error(const Matrix& a, Symmetry symmetry, std::string_view comment = {}) {
  try {
    format_matrix_market(a, symmetry, comment);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  return "(accepted)";
}

// One value as 1 × 1 matrix of the field real.
std::string with_value(std::string_view value) {
  return "%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 " + std::string(value) + "\n";
}

bool same_bits(const Matrix& a, const Matrix& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols()) return false;
  for (Index k = 0; k < a.size(); ++k) {
    if (std::bit_cast<std::uint64_t>(a.data()[k]) != std::bit_cast<std::uint64_t>(b.data()[k])) return false;
  }
  return true;
}

// ---- what is read

TEST(MatrixMarketReads, CoordinateGeneral) {
  Matrix expected(2, 3);
  expected << 1.5, 0, -2, 0, 1e-3, 0;
  EXPECT_EQ(parse("%%MatrixMarket matrix coordinate real general\n2 3 3\n1 1 1.5\n1 3 -2\n2 2 1e-3\n"), expected);
}

TEST(MatrixMarketReads, CoordinateSymmetricFromItsLowerTriangle) {
  Matrix expected(2, 2);
  expected << 4, -1, -1, 5;
  EXPECT_EQ(parse("%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 4\n2 1 -1\n2 2 5\n"), expected);
}

TEST(MatrixMarketReads, SkewSymmetricUnit) {
  // The file's entry is the one below the diagonal: J = [0 −1; 1 0] of a wheel about +z is "2 1 1".
  Matrix expected(2, 2);
  expected << 0, -1, 1, 0;
  EXPECT_EQ(parse("%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 1\n"), expected);
  EXPECT_EQ(parse("%%MatrixMarket matrix array real skew-symmetric\n2 2\n1\n"), expected);
}

TEST(MatrixMarketReads, ZeroOnTheDiagonalOfSkewSymmetric) {
  const Matrix a = parse("%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 3\n1 1 0\n2 1 0\n2 2 -0.0\n");
  EXPECT_TRUE(same_bits(a.row(0), Matrix::Zero(1, 2))) << "the mirrored zero must be +0";
}

TEST(MatrixMarketReads, ArrayColumnByColumn) {
  Matrix expected(2, 3);
  expected << 1, 3, 5, 2, 4, 6;
  EXPECT_EQ(parse("%%MatrixMarket matrix array real general\n2 3\n1\n2\n3\n4\n5\n6\n"), expected);
}

TEST(MatrixMarketReads, ArrayOfOneTriangle) {
  Matrix symmetric(3, 3);
  symmetric << 1, 2, 3, 2, 4, 5, 3, 5, 6;
  EXPECT_EQ(parse("%%MatrixMarket matrix array integer symmetric\n3 3\n1\n2\n3\n4\n5\n6\n"), symmetric);
  Matrix skew(3, 3);
  skew << 0, -1, -2, 1, 0, -3, 2, 3, 0;
  EXPECT_EQ(parse("%%MatrixMarket matrix array integer skew-symmetric\n3 3\n1\n2\n3\n"), skew);
  EXPECT_EQ(parse("%%MatrixMarket matrix array real skew-symmetric\n1 1\n"), Matrix::Zero(1, 1));
}

TEST(MatrixMarketReads, MatrixWithoutEntries) {
  EXPECT_EQ(parse("%%MatrixMarket matrix coordinate real general\n2 3 0\n"), Matrix::Zero(2, 3));
}

TEST(MatrixMarketReads, CrlfTabsBlanksCommentsAndNoFinalNewline) {
  EXPECT_EQ(parse("%%MatrixMarket\tMATRIX Coordinate REAL General \r\n% Ω = 3 rad/s\r\n\r\n  %\r\n \t2 1\t2 \r\n"
                  "%between\r\n\r\n  1 1\t1.5\r\n \t \r\n2 1 2.5"),
            Eigen::Vector2d(1.5, 2.5));
}

TEST(MatrixMarketReads, NumbersAsFortranAndCWriteThem) {
  const std::vector<std::pair<std::string, double>> numbers = {
      {"1.0D+03", 1000},
      {"-2.5d-1", -0.25},
      {"+3", 3},
      {"+.5E+1", 5},
      {"7.", 7},
      {"0.1", 0.1},
      {"1e-400", 0},
      {"-1e-400", 0},
      {"0e999", 0},
      {"4.9e-324", std::numeric_limits<double>::denorm_min()},
      {"1e-310", 1e-310},
      {"1.7976931348623157e308", std::numeric_limits<double>::max()},
      {"0." + std::string(400, '0') + "1e+20", 0},  // below 1e-324 with a positive exponent
      {"1" + std::string(400, '0') + "e-400", 1},   // long, yet in range
      {"1e-99999999999999999999", 0}};
  for (const auto& [word, value] : numbers) EXPECT_EQ(parse(with_value(word))(0, 0), value) << word;
}

TEST(MatrixMarketReads, IntegersUpToTwoToThe53) {
  const Matrix a = parse("%%MatrixMarket matrix array integer general\n3 1\n9007199254740992\n-9007199254740992\n+7\n");
  EXPECT_EQ(a, Eigen::Vector3d(9007199254740992.0, -9007199254740992.0, 7));
}

// ---- what is refused: the message names file, line, value and expectation

struct Refusal {
  std::string name;
  std::string text;
  std::string message;
  friend std::ostream& operator<<(std::ostream& out, const Refusal& r) { return out << r.name; }
};

class MatrixMarketRefuses : public testing::TestWithParam<Refusal> {};

TEST_P(MatrixMarketRefuses, WithMessage) { EXPECT_EQ(parse_error(GetParam().text), GetParam().message); }

const std::string general = "%%MatrixMarket matrix coordinate real general\n";
const std::string symmetric = "%%MatrixMarket matrix coordinate real symmetric\n";
const std::string skew = "%%MatrixMarket matrix coordinate real skew-symmetric\n";
const std::string array = "%%MatrixMarket matrix array real general\n";
const std::string banner_form = "'%%MatrixMarket matrix coordinate|array real|integer general|symmetric|skew-symmetric' was expected";

INSTANTIATE_TEST_SUITE_P(
    Banner, MatrixMarketRefuses,
    testing::Values(
        Refusal{"Empty", "", "K.mtx: is empty: " + banner_form + " as its first line"},
        Refusal{"BlankFirst", "\n" + general + "1 1 0\n", "K.mtx:1: first line '' is not a banner: " + banner_form},
        Refusal{"NoBanner", "1 1 1\n1 1 1\n", "K.mtx:1: first line '1 1 1' is not a banner: " + banner_form},
        Refusal{"ByteOrderMark", "\xEF\xBB\xBF" + general,
                "K.mtx:1: first line '\\xef\\xbb\\xbf%%MatrixMarket matrix coordinate real...' is not a banner: " + banner_form},
        Refusal{"WordMissing", "%%MatrixMarket matrix array real\n1 1\n1\n",
                "K.mtx:1: first line '%%MatrixMarket matrix array real' is not a banner: " + banner_form},
        Refusal{"WordTooMany", "%%MatrixMarket matrix array real general x\n1 1\n1\n",
                "K.mtx:1: first line '%%MatrixMarket matrix array real general...' is not a banner: " + banner_form},
        Refusal{"Object", "%%MatrixMarket vector array real general\n1 1\n1\n",
                "K.mtx:1: object 'vector' is not read: matrix was expected"},
        Refusal{"Format", "%%MatrixMarket matrix csr real general\n1 1\n1\n",
                "K.mtx:1: format 'csr' is not read: coordinate or array was expected"},
        Refusal{"Field", "%%MatrixMarket matrix array r\x1b[31m general\n",
                "K.mtx:1: field 'r\\x1b[31m' is not read: real or integer was expected"},
        Refusal{"Complex", "%%MatrixMarket matrix array Complex general\n",
                "K.mtx:1: field 'Complex' is not read (only real matrices are): real or integer was expected"},
        Refusal{"Pattern", "%%MatrixMarket matrix coordinate pattern general\n",
                "K.mtx:1: field 'pattern' is not read (it has no values): real or integer was expected"},
        Refusal{"Hermitian", "%%MatrixMarket matrix array real hermitian\n",
                "K.mtx:1: symmetry 'hermitian' is not read (only real matrices are): general or symmetric or skew-symmetric was expected"},
        Refusal{"Symmetry", "%%MatrixMarket matrix array real skew\n",
                "K.mtx:1: symmetry 'skew' is not read: general or symmetric or skew-symmetric was expected"},
        Refusal{"Binary", general + "1 1 1\n" + std::string("1 1 \0", 5),
                "K.mtx:3: byte '\\x00' is not text: this is a binary file, a Matrix Market file was expected"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    SizeLine, MatrixMarketRefuses,
    testing::Values(
        Refusal{"Missing", general + "% nothing\n", "K.mtx:2: the file ends here: the size line 'rows columns entries' was expected"},
        Refusal{"MissingInArray", array, "K.mtx:1: the file ends here: the size line 'rows columns' was expected"},
        Refusal{"TooShort", general + "2 2\n", "K.mtx:2: line '2 2' is too short: the size line 'rows columns entries' was expected"},
        Refusal{"TooLong", array + "2 2 4\n", "K.mtx:2: '4' is one too many on its line: the size line 'rows columns' was expected"},
        Refusal{"Malformed", general + "2 2.0 1\n", "K.mtx:2: number of columns '2.0': a whole number from 1 to 2147483647 was expected"},
        Refusal{"Negative", general + "-2 2 1\n", "K.mtx:2: number of rows '-2': a whole number from 1 to 2147483647 was expected"},
        Refusal{"Zero", general + "0 2 0\n", "K.mtx:2: number of rows '0': a whole number from 1 to 2147483647 was expected"},
        Refusal{"BeyondRange", array + "1 99999999999999999999\n",
                "K.mtx:2: number of columns '99999999999999999999': a whole number from 1 to 2147483647 was expected"},
        Refusal{"NegativeEntries", general + "2 2 -1\n",
                "K.mtx:2: number of entries '-1': a whole number from 0 to 9223372036854775807 was expected"},
        Refusal{"NotSquare", symmetric + "2 3 1\n1 1 1\n", "K.mtx:2: size 2 x 3 is not square: the first line promises symmetry"},
        Refusal{"Enormous", general + "1000000000 1000000000 3\n1 1 1\n2 2 1\n3 3 1\n",
                "K.mtx:2: size 1000000000 x 1000000000 with 3 entries is not read as a dense matrix of 8e+09 GB: at most 0.268 GB, or "
                "sides up to 46000 and an entry for each row or column was expected"},
        Refusal{"EnormousArray", array + "2147483647 2147483647\n1\n2\n",
                "K.mtx:4: the file ends after 2 of the 4611686014132420609 values that line 2 promises"},
        Refusal{"EnormousTriangle", "%%MatrixMarket matrix array real symmetric\n2147483647 2147483647\n",
                "K.mtx:2: the file ends after 0 of the 2305843008139952128 values that line 2 promises"}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Entries, MatrixMarketRefuses,
    testing::Values(
        Refusal{"Truncated", general + "3 3 3\n1 1 1\n2 2 1\n", "K.mtx:4: the file ends after 2 of the 3 entries that line 2 promises"},
        Refusal{"PromisesManyMore", general + "3 3 9223372036854775807\n1 1 1\n",
                "K.mtx:3: the file ends after 1 of the 9223372036854775807 entries that line 2 promises"},
        Refusal{"TruncatedArray", array + "2 2\n1\n2\n3\n", "K.mtx:5: the file ends after 3 of the 4 values that line 2 promises"},
        Refusal{"TooMany", general + "2 2 1\n1 1 1\n2 2 5\n", "K.mtx:4: '2 2 5' is one too many: line 2 promises 1"},
        Refusal{"TooManyInArray", array + "1 1\n1\n2\n", "K.mtx:4: '2' is one too many: line 2 promises 1"},
        Refusal{"TooManyInSkewArray", "%%MatrixMarket matrix array real skew-symmetric\n2 2\n1\n2\n",
                "K.mtx:4: 2 values: line 2 promises 1, or 3 with the zero diagonal"},
        Refusal{"TooShort", general + "2 2 1\n1 1\n", "K.mtx:3: line '1 1' is too short: 'row column value' was expected"},
        Refusal{"Garbage", general + "2 2 1\n1 1 1 kg\n", "K.mtx:3: 'kg' is one too many on its line: 'row column value' was expected"},
        Refusal{"GarbageInArray", array + "1 1\n1 % one\n", "K.mtx:3: '%' is one too many on its line: one value a line was expected"},
        Refusal{"RowZero", general + "2 2 1\n0 1 1\n", "K.mtx:3: row '0' is outside the matrix: a whole number from 1 to 2 was expected"},
        Refusal{"RowBeyond", general + "2 2 1\n3 1 1\n", "K.mtx:3: row '3' is outside the matrix: a whole number from 1 to 2 was expected"},
        Refusal{"ColumnBeyond", general + "2 2 1\n1 3 1\n",
                "K.mtx:3: column '3' is outside the matrix: a whole number from 1 to 2 was expected"},
        Refusal{"ColumnNoNumber", general + "2 2 1\n1 x 1\n",
                "K.mtx:3: column 'x' is outside the matrix: a whole number from 1 to 2 was expected"},
        Refusal{"Repeated", general + "2 2 4\n2 1 1\n1 1 1\n% again\n2 1 1\n1 1 1\n",
                "K.mtx:6: entry (2,1) was already given in line 3: each entry once was expected"},
        Refusal{"AboveDiagonal", symmetric + "2 2 1\n1 2 1\n",
                "K.mtx:3: entry (1,2) is above the diagonal: with symmetry only the lower triangle was expected"},
        Refusal{"AboveDiagonalSkew", skew + "2 2 1\n1 2 1\n",
                "K.mtx:3: entry (1,2) is above the diagonal: with symmetry only the lower triangle was expected"},
        Refusal{"DiagonalOfSkew", skew + "2 2 1\n2 2 3.0\n",
                "K.mtx:3: entry (2,2) = 3.0 is on the diagonal of a skew-symmetric matrix: zero or no entry was expected"},
        Refusal{"NotInteger", "%%MatrixMarket matrix array integer general\n1 1\n2.5\n",
                "K.mtx:3: value '2.5' is not a whole number within 2^53: the first line promises the field integer"},
        Refusal{"IntegerBeyondDouble", "%%MatrixMarket matrix array integer general\n1 1\n9007199254740993\n",
                "K.mtx:3: value '9007199254740993' is not a whole number within 2^53: the first line promises the field integer"}),
    [](const auto& test) { return test.param.name; });

TEST(MatrixMarketRefusal, WordsThatAreNoNumber) {
  for (const std::string word : {"abc", "1e", "e5", "--1", "+-1", "1,5", "0x10", "1..2", "+", "D", "1d", "nand", "1e5e5", "."}) {
    EXPECT_EQ(parse_error(with_value(word)), "K.mtx:3: value '" + word + "' is not a number: 'row column value' was expected");
  }
}

TEST(MatrixMarketRefusal, NumbersThatAreNotFinite) {
  const std::string long_number = "1" + std::string(400, '0');
  for (const std::string& word : {std::string("nan"), std::string("-inf"), std::string("Infinity"), std::string("1e999"),
                                  std::string("-1.0D+400"), std::string("1e99999999999999999999")}) {
    EXPECT_EQ(parse_error(with_value(word)),
              "K.mtx:3: value '" + word + "' is not finite as a double: at most 1.8e308 in magnitude was expected");
  }
  EXPECT_EQ(parse_error(with_value(long_number + "e-5")),
            "K.mtx:3: value '" + long_number.substr(0, 40) + "...' is not finite as a double: at most 1.8e308 in magnitude was expected");
}

TEST(MatrixMarketRefusal, LongAndUnprintableWordsAreCutAndEscaped) {
  EXPECT_EQ(parse_error(with_value("\x1b[2J" + std::string(1'000'000, 'x'))),
            "K.mtx:3: value '\\x1b[2J" + std::string(36, 'x') + "...' is not a number: 'row column value' was expected");
}

TEST(MatrixMarketRefusal, FilesThatAreNone) {
  const fs::path folder = testing::TempDir();
  EXPECT_EQ(read_error(folder / "no.mtx"),
            (folder / "no.mtx").string() + ": cannot be opened (No such file or directory): a Matrix Market file was expected");
  EXPECT_EQ(read_error(folder), folder.string() + ": is a directory: a Matrix Market file was expected");
}

// ---- memory: the rule, and what it lets in

TEST(MatrixMarketMemory, FitsDense) {
  EXPECT_TRUE(fits_dense(5792, 5792, 2)) << "256 MiB whatever the entries";
  EXPECT_FALSE(fits_dense(5793, 5793, 5792));
  EXPECT_TRUE(fits_dense(5793, 5793, 5793));
  EXPECT_TRUE(fits_dense(20'000, 20'000, 20'000));
  EXPECT_TRUE(fits_dense(46'000, 46'000, 46'000));
  EXPECT_FALSE(fits_dense(46'001, 46'001, 46'001));
  EXPECT_TRUE(fits_dense(33'554'432, 1, 1));
  EXPECT_FALSE(fits_dense(33'554'433, 1, 33'554'433));
  EXPECT_FALSE(fits_dense(2'147'483'647, 2'147'483'647, 9'000'000'000'000'000'000));
}

TEST(MatrixMarketMemory, WriterShowsTheDiagonalWhereTheReaderAsksForIt) {
  Matrix g = Matrix::Zero(5800, 5800);  // a wheel among 5800 coordinates: 269 MB
  g(5799, 0) = 2.5;
  g(0, 5799) = -2.5;
  const std::string text = format_matrix_market(g, Symmetry::skew_symmetric);
  EXPECT_TRUE(text.starts_with("%%MatrixMarket matrix coordinate real skew-symmetric\n5800 5800 5801\n1 1 0\n5800 1 2.5\n2 2 0\n"));
  EXPECT_EQ(parse(text), g);
}

TEST(MatrixMarketMemory, HeaderTakesNoMemoryBeforeItsEntriesAreRead) {
  // 46 000 × 46 000 would be 17 GB; the file ends after one of the entries it promises.
  EXPECT_EQ(parse_error(general + "46000 46000 46000\n1 1 1\n"),
            "K.mtx:3: the file ends after 1 of the 46000 entries that line 2 promises");
}

TEST(MatrixMarketMemory, FailedAllocationIsAnInputError) {
  if (address_sanitizer) GTEST_SKIP() << "it ends the program where memory fails, and needs terabytes of addresses";
  std::string text = general + "46000 46000 46000\n";
  for (int k = 1; k <= 46'000; ++k) text += std::to_string(k) + " 1 1\n";
  rlimit before{};
  getrlimit(RLIMIT_AS, &before);
  const rlimit narrow{.rlim_cur = rlim_t{4} << 30, .rlim_max = before.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_AS, &narrow), 0);
  const std::string message = parse_error(text);
  setrlimit(RLIMIT_AS, &before);
  EXPECT_EQ(message, "K.mtx:2: there is no memory for a dense 46000 x 46000 matrix");
}

TEST(MatrixMarketMemory, OrderThatServesTheCaller) {
  const auto refusal = [](const std::string& text, Index most) -> std::string {
    try {
      parse_matrix_market(text, "K.mtx", most);
    } catch (const Unreadable& e) {
      return e.what();
    }
    return "(accepted)";
  };
  EXPECT_EQ(refusal(general + "3 3 0\n", 2), "K.mtx:2: size 3 x 3 is too large: dense models have at most 2 coordinates");
  EXPECT_EQ(refusal(general + "3 3 0\n", 3), "(accepted)");
  EXPECT_EQ(refusal(array + "3 1\n1\n2\n3\n", 2), "K.mtx:2: size 3 x 1 is too large: dense models have at most 2 coordinates");
}

// ---- what is written

TEST(MatrixMarketWrites, TheLowerTriangleWithItsComment) {
  Matrix k(2, 2);
  k << 4, -0.1, -0.1, 0;
  EXPECT_EQ(format_matrix_market(k, Symmetry::symmetric, "stiffness, N/m\nof the mast"),
            "%%MatrixMarket matrix coordinate real symmetric\n% stiffness, N/m\n% of the mast\n2 2 2\n1 1 4\n2 1 -0.1\n");
}

TEST(MatrixMarketWrites, CommentsThatLookLikeContent) {
  const Matrix a = Matrix::Constant(1, 1, 0.1);
  EXPECT_EQ(parse(format_matrix_market(a, Symmetry::general, "\n1 1 1\r\n%%MatrixMarket\n\n")), a);
}

TEST(MatrixMarketWrites, FileAndBack) {
  const fs::path file = fs::path(testing::TempDir()) / "gyromode_matrix_market_round_trip.mtx";
  const Matrix a = Matrix::Random(70, 50);  // text longer than one chunk of the reader
  write_matrix_market(file, a, Symmetry::general, "random");
  EXPECT_GT(fs::file_size(file), std::uintmax_t{1 << 16});
  EXPECT_TRUE(same_bits(read_matrix_market(file), a));
  fs::remove(file);
}

TEST(MatrixMarketWrites, RefusalLeavesTheFileAsItWas) {
  const fs::path file = fs::path(testing::TempDir()) / "gyromode_matrix_market_kept.mtx";
  write_matrix_market(file, Matrix::Identity(2, 2), Symmetry::symmetric);
  EXPECT_THROW(write_matrix_market(file, Matrix::Constant(2, 2, NAN), Symmetry::symmetric), InvalidArgument);
  EXPECT_EQ(read_matrix_market(file), Matrix::Identity(2, 2));
  fs::remove(file);
}

TEST(MatrixMarketWrites, NowhereIsAnInputError) {
  EXPECT_THROW(write_matrix_market("/nowhere/K.mtx", Matrix::Identity(2, 2), Symmetry::symmetric), Unreadable);
}

TEST(MatrixMarketWrites, OnlyWhatTheFileCanHold) {
  Matrix a(2, 2);
  a << 1, 3, -2.5, 1;
  EXPECT_EQ(format_error(a, Symmetry::symmetric),
            "a symmetric file holds the lower triangle only: entries (1,0) = -2.5 and (0,1) = 3 do not match");
  EXPECT_EQ(format_error(a, Symmetry::skew_symmetric), "a skew-symmetric file holds the lower triangle only: entry (0,0) = 1 is not zero");
  EXPECT_EQ(format_error(Matrix::Zero(2, 3), Symmetry::symmetric), "a symmetric matrix must be square: this one is 2 x 3");
  EXPECT_EQ(format_error(Matrix::Zero(0, 3), Symmetry::general), "a Matrix Market file holds one row and column at least: this is 0 x 3");
  a(1, 0) = INFINITY;
  EXPECT_EQ(format_error(a, Symmetry::general), "a Matrix Market file holds finite values: entry (1,0) = inf");
  EXPECT_EQ(format_error(Matrix::Identity(1, 1), Symmetry::general, std::string_view("a\0b", 3)),
            "a comment in a Matrix Market file must be text: it holds a NUL byte");
}

// ---- property: what is written is read, to the last bit

// Any finite double, denormals included, each bit pattern as likely as the next; zero half the time.
double any_double(std::mt19937_64& random) {
  if (random() % 2 == 0) return 0;
  double value = 0;
  do {
    value = std::bit_cast<double>(std::uint64_t{random()});
  } while (!std::isfinite(value) || value == 0);
  return value;
}

Matrix any_matrix(std::mt19937_64& random, Index rows, Index cols, Symmetry symmetry) {
  Matrix a = Matrix::NullaryExpr(rows, cols, [&](Index, Index) { return any_double(random); });
  if (symmetry == Symmetry::general) return a;
  for (Index j = 0; j < cols; ++j) {
    for (Index i = 0; i < j; ++i) a(i, j) = symmetry == Symmetry::symmetric ? a(j, i) : 0.0 - a(j, i);
    if (symmetry == Symmetry::skew_symmetric) a(j, j) = 0;
  }
  return a;
}

TEST(MatrixMarketProperty, RoundTripIsExact) {
  std::mt19937_64 random(20240611);
  for (const Symmetry symmetry : {Symmetry::general, Symmetry::symmetric, Symmetry::skew_symmetric}) {
    for (int trial = 0; trial < 300; ++trial) {
      const auto rows = static_cast<Index>(1 + random() % 12);
      const auto cols = symmetry == Symmetry::general ? static_cast<Index>(1 + random() % 12) : rows;
      const Matrix a = any_matrix(random, rows, cols, symmetry);
      const std::string text = format_matrix_market(a, symmetry, "trial " + std::to_string(trial));
      ASSERT_TRUE(same_bits(parse(text), a)) << text;
      ASSERT_TRUE(same_bits(parse(format_matrix_market(a, Symmetry::general)), a)) << text;
    }
  }
}

TEST(MatrixMarketProperty, EveryTruncationBeforeTheLastValueIsRefused) {
  const std::string text = "%%MatrixMarket matrix coordinate real symmetric\n% c\n2 2 3\n1 1 4.25\n2 1 -1.5\n2 2 5.75\n";
  const std::size_t last_value = text.find("5.75");
  for (std::size_t length = 0; length <= last_value; ++length) {
    EXPECT_TRUE(parse_error(text.substr(0, length)).starts_with("K.mtx:")) << text.substr(0, length);
  }
}

}  // namespace
}  // namespace gyromode::io
