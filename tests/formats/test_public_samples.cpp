// The forms that files of other programs have where public collections show them, rebuilt by hand with numbers of our
// own: Nastran's OUTPUT4 files in the test data of pyYeti (twmacro/pyyeti, tests/nastran_op4_data) and DMIG punched by
// Nastran (tests/nastran_dmig_data); DMIG as APDL's *DMAT documents it; Harwell–Boeing files of HB_IO (J. Burkardt), of
// scipy's tests and of SuiteSparse's RBio.
#include "gyromode/base/error.h"
#include "gyromode/formats/matrix_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace gyromode {
namespace {

const Matrix stiffness{{10, -1, 0}, {-1, 20.5, -.125}, {0, -.125, 30}};

std::vector<NamedMatrix> all_of(const std::string& bytes) { return parse_matrices(bytes, "K.dat", 100); }

Matrix parsed(const std::string& bytes) {
  const auto all = all_of(bytes);
  EXPECT_EQ(all.size(), 1U);
  return all.front().matrix;
}

std::string refusal(const std::string& bytes) {
  try {
    chosen_matrix(all_of(bytes), {"K.dat", ""});
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

// rd.op4, double_dense_ascii.op4: in text, dense columns of double precision count values, not words.
TEST(NastranOutput4, DenseTextCountsValues) {
  for (const std::string format : {"1P,3E24.17", "1P,2E24.17", "1P,1E24.17"}) {
    const int each = format[3] - '0';
    std::string text = "       3       3       6       2K       " + format + "\n";
    const auto column = [&](int j, int first, const std::vector<std::string>& values) {
      char head[32];
      std::snprintf(head, sizeof head, "%8d%8d%8d", j, first, static_cast<int>(values.size()));
      text += head;
      for (std::size_t k = 0; k < values.size(); ++k) text += (k % static_cast<std::size_t>(each) == 0 ? "\n" : "") + values[k];
      text += "\n";
    };
    column(1, 1, {" 1.00000000000000000E+01", "-1.00000000000000000E+00"});
    column(2, 1, {"-1.00000000000000000E+00", " 2.05000000000000000E+01", "-1.25000000000000000E-01"});
    column(3, 2, {"-1.25000000000000000E-01", " 3.00000000000000000E+01"});
    column(4, 1, {" 1.00000000000000000E+00"});
    EXPECT_EQ(parsed(text), stiffness) << format;
  }
}

// double_nonbigmat_ascii.op4.other: headers of strings twelve columns wide, as L · 65536 + row needs them.
TEST(NastranOutput4, HeadersOfStringsMayBeWide) {
  EXPECT_EQ(parsed("       3       3       6       1K       1P,5E16.9\n"
                   "       1       0       3\n      196609\n 1.000000000E+01-1.000000000E+00\n"
                   "       2       0       4\n      262145\n-1.000000000E+00 2.050000000E+01-1.250000000E-01\n"
                   "       3       0       4\n      131074\n-1.250000000E-01\n      131075\n 3.000000000E+01\n"
                   "       4       1       1\n 1.000000000E+00\n"),
            stiffness);
}

// r_c_rc.op4, double_bigmat_ascii_badname.op4: complex matrices beside real ones are passed over, and named when asked
// for.
TEST(NastranOutput4, ComplexMatricesArePassedOver) {
  const std::string real =
      "       2      -2       6       21KAA@@@@1P,3E23.16\n"
      "       1       0       4\n       3       1\n 4.0000000000000000E+00\n"
      "       2       0       4\n       3       2\n 5.0000000000000000E+00\n"
      "       3       1       1\n 1.0000000000000000E+00\n";
  const std::string complex_dense =
      "       2       2       6       4CMAT    1P,5E16.9\n"
      "       1       1       4\n 1.000000000E+00 2.000000000E+00 0.000000000E+00 1.000000000E+00\n"
      "       3       1       1\n 1.000000000E+00\n";
  const std::string complex_big =
      "       2      -2       6       3CBIG    1P,5E16.9\n"
      "       1       0       4\n       3       1\n 1.000000000E+00 2.000000000E+00\n"
      "       3       1       1\n 1.000000000E+00\n";
  std::string name_with_nul = real;
  std::replace(name_with_nul.begin(), name_with_nul.end(), '@', '\0');
  const auto all = all_of(complex_dense + name_with_nul + complex_big);
  ASSERT_EQ(all.size(), 3U);
  EXPECT_EQ(all[1].matrix, (Matrix{{4, 0}, {0, 5}}));
  EXPECT_TRUE(all[0].name == "CMAT" && all[0].unfit == "is complex" && all[0].matrix.size() == 0);
  EXPECT_EQ(chosen_matrix(all, {"K.op4", ""}).matrix, all[1].matrix);
  EXPECT_THROW(chosen_matrix(all, {"K.op4", "CBIG"}), Unreadable);
  EXPECT_EQ(refusal(complex_dense), "K.dat: 'CMAT' is complex: a matrix of real numbers was expected");
}

class WideRecords {
 public:
  explicit WideRecords(bool swapped) : swapped_(swapped) {}
  template <class T>
  std::string bytes_of(T value) const {
    std::string b(sizeof(T), '\0');
    std::memcpy(b.data(), &value, sizeof(T));
    if (swapped_) std::reverse(b.begin(), b.end());
    return b;
  }
  std::string whole(std::initializer_list<std::int64_t> values) const {
    std::string all;
    for (const std::int64_t v : values) all += bytes_of(v);
    return all;
  }
  void record(const std::string& content) {
    const std::string length = bytes_of(static_cast<std::int32_t>(content.size()));
    all_ += length + content + length;
  }
  const std::string& all() const { return all_; }

 private:
  bool swapped_;
  std::string all_;
};

// double_dense_le_i64.op4, binary_fabiola.op4 and the like: whole numbers and words of eight bytes, both endians.
TEST(NastranOutput4, WideBinaryFiles) {
  for (const bool swapped : {false, true}) {
    for (const std::int64_t type : {1, 2}) {  // single and double alike
      WideRecords dense(swapped), strings(swapped);
      dense.record(dense.whole({3, 3, 6, type}) + "K               ");
      strings.record(strings.whole({3, -3, 6, type}) + "K               ");
      for (std::int64_t j = 0; j < 3; ++j) {
        std::string values, parts;
        for (std::int64_t i = 0; i < 3; ++i) {
          values += dense.bytes_of(stiffness(i, j));
          if (stiffness(i, j) != 0) parts += dense.whole({2, i + 1}) + dense.bytes_of(stiffness(i, j));
        }
        dense.record(dense.whole({j + 1, 1, 3}) + values);
        strings.record(strings.whole({j + 1, 0, static_cast<std::int64_t>(parts.size() / 8)}) + parts);
      }
      for (WideRecords* r : {&dense, &strings}) {
        r->record(r->whole({4, 1, 1}) + r->bytes_of(1.0));
        EXPECT_EQ(parsed(r->all()), stiffness) << swapped << type;
      }
    }
  }
}

// matrix_factory.pch: large field with exponents D, several matrices, a complex one; other entries of a deck before
// them.
TEST(NastranDmig, AsPunched) {
  const auto all = all_of(
      "$TITLE   = A MODEL                                                             1\n"
      "BEGIN BULK\n"
      "GRID    1               0.      0.      0.\n"
      "DMIG    IDENT          0       6       2       0                       2\n"
      "DMIG*   IDENT                          1               1\n"
      "*                      1               1 1.000000000D+00\n"
      "DMIG*   IDENT                         10               0\n"
      "*                     10               0-2.500000000D-01\n"
      "DMIG    CMPLX          0       1       4       0                       2\n"
      "DMIG*   CMPLX                          1               1\n"
      "*                      1               1 1.000000000D+00 2.000000000D+00\n"
      "ENDDATA\n");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].matrix, (Matrix{{1, 0}, {0, -.25}}));
  EXPECT_EQ(all[0].labels, (Labels{"1.1", "10"}));
  EXPECT_EQ(all[1].unfit, "is complex");
}

TEST(NastranDmig, FreeFieldPartedByBlanks) {
  const auto all = all_of("DMIG stiff 0 6 2 0\nDMIG stiff 1 2 1 2 29988. 1 6 149940.\nDMIG stiff 1 6 1 6 999600.\n");
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].name, "stiff");
  EXPECT_EQ(all[0].matrix, (Matrix{{29988, 149940}, {149940, 999600}}));
}

// *MATRIX OUTPUT, FORMAT=MATRIX INPUT and FORMAT=COORDINATE of Abaqus; .sti and .mas of CalculiX, one triangle.
TEST(ListsOfEntries, AbaqusAndCalculix) {
  EXPECT_EQ(parsed("1 1 10.\n2 1 -1\n2 2 2.05e1\n3 2 -1.25E-01\n3 3 30\n"), stiffness);
  EXPECT_EQ(parsed("1 1 10.\n1 2 -1\n2 1 -1\n2 2 2.05e1\n2 3 -0.125\n3 2 -1.25E-01\n3 3 30\n"), stiffness);
  EXPECT_EQ(parsed("1 2 1.5\n1 3 -2\n2 3 .25\n1 4 0\n"), (Matrix{{0, 1.5, -2, 0}, {-1.5, 0, .25, 0}, {2, -.25, 0, 0}, {0, 0, 0, 0}}));
  const auto by_nodes = all_of("7,1, 7,1, 10.0\n7,2, 7,1, -1\n7,2, 7,2, 20.5\n9,3, 7,2, -0.125\n9,3, 9,3, 30\n");
  EXPECT_EQ(by_nodes.front().matrix, stiffness);
  EXPECT_EQ(by_nodes.front().labels, (Labels{"7.1", "7.2", "9.3"}));
}

TEST(ListsOfEntries, MatricesOfThreeAndFiveRowsStayMatrices) {
  EXPECT_EQ(parsed("10 -1 0\n-1 20.5 -0.125\n0 -0.125 30\n"), stiffness);
  EXPECT_EQ(parsed("1 2 3\n2 1 2\n3 2 1\n"), (Matrix{{1, 2, 3}, {2, 1, 2}, {3, 2, 1}}));
  EXPECT_EQ(parsed("1 2 3\n2 1 4\n3 3 1\n"), (Matrix{{1, 2, 3}, {2, 1, 4}, {3, 3, 1}}));  // two of three not on the diagonal
  EXPECT_EQ(parsed("1 1 4\n2 2 5\n3 3 6\n"), (Matrix{{4, 0, 0}, {0, 5, 0}, {0, 0, 6}}));  // no matrix that anybody has
}

// rua_32_file.txt: a title that begins with 1, right-hand sides behind, which are passed over.
TEST(HarwellBoeingSamples, RightHandSidesArePassedOver) {
  EXPECT_EQ(parsed("1Real unsymmetric assembled matrix                                      RUA_3   \n"
                   "             6             1             1             2             2\n"
                   "RUA                        3             3             7             0\n"
                   "(16I5)          (16I5)          (5F7.3)             (5F7.3)             \n"
                   "FGX                        1             0\n"
                   "    1    3    6    8\n"
                   "    1    2    1    2    3    2    3\n"
                   " 10.000 -1.000 -1.000 20.500 -0.125\n"
                   " -0.125 30.000\n"
                   "  1.000  2.000  3.000\n"
                   "  1.000  1.000  1.000\n"),
            stiffness);
}

// bcsstk01.rb: the header of Rutherford and Boeing, four lines, type in small letters; scipy's: columns filled from the
// left.
TEST(HarwellBoeingSamples, RutherfordAndScipy) {
  EXPECT_EQ(parsed("G/three; 1982; ed: I. Duff et al.                                      |23      \n"
                   "             4             1             1             2\n"
                   "rsa                        3             3             5             0\n"
                   "(20I4)          (26I3)          (4E20.12)           \n"
                   "   1   3   5   6\n"
                   "  1  2  2  3  3\n"
                   "  0.100000000000E+02 -0.100000000000E+01  0.205000000000E+02 -0.125000000000E+00\n"
                   "  0.300000000000E+02\n"),
            stiffness);
  EXPECT_EQ(parsed("No Title                                                                |No Key\n"
                   "             5             1             1             3\n"
                   "RUA                        3             3             7             0\n"
                   "(26I3)          (26I3)          (3E23.15)\n"
                   "1  3  6  8\n"
                   "1  2  1  2  3  2  3\n"
                   "1.000000000000000e+01 -1.000000000000000e+00 -1.000000000000000e+00\n"
                   " 2.050000000000000e+01 -1.250000000000000e-01 -1.250000000000000e-01\n"
                   " 3.000000000000000e+01\n"),
            stiffness);
}

}  // namespace
}  // namespace gyromode
