// Matrix files of other programs: files that numpy, scipy and Octave wrote (files/), and formats rebuilt by hand from
// their published descriptions.
#include "gyromode/formats/matlab.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/formats/number_table.h"
#include "gyromode/formats/numpy.h"

#include <gtest/gtest.h>

#include <matio.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>

namespace gyromode {
namespace {

namespace fs = std::filesystem;

const fs::path files = fs::path(GYROMODE_SOURCE_DIR) / "tests" / "formats" / "files";
const Matrix mass{{4, .5, 0}, {.5, 3, .25}, {0, .25, 2}}, gyroscopic{{0, 1.5, -2}, {-1.5, 0, .125}, {2, -.125, 0}},
    stiffness{{10, -1, 0}, {-1, 20.5, -.1}, {0, -.1, 30}};

Matrix the_one(const std::string& name) {
  const MatrixPlace place = matrix_place(files / name);
  return chosen_matrix(read_matrices_of(place.file), place).matrix;
}

std::string refusal(const std::string& bytes, const std::string& name = "K.dat") {
  try {
    chosen_matrix(parse_matrices(bytes, name, 100), {name, ""});
  } catch (const Error& e) {
    return e.what();
  }
  return "accepted";
}

std::string refusal_of(const std::string& file) {
  try {
    the_one(file);
  } catch (const Error& e) {
    return std::string(e.what()).substr(files.string().size() + 1);
  }
  return "accepted";
}

void expect_refused(const std::string& bytes, const std::string& words) {
  const std::string said = refusal(bytes);
  EXPECT_NE(said.find(words), std::string::npos) << said;
}

Matrix parsed(const std::string& bytes) {
  const auto all = parse_matrices(bytes, "K.dat", 100);
  EXPECT_EQ(all.size(), 1U);
  return all.front().matrix;
}

TEST(MatrixFiles, OfNumpyAndScipy) {
  for (const char* name : {"M.npy", "M_fortran.npy", "M_big_endian.npy", "M_single.npy", "stored.npz:M", "deflated.npz:mass",
                           "scipy_v5.mat:M", "scipy_v4.mat:M", "scipy_compressed.mat:Mass"})
    EXPECT_EQ(the_one(name), mass) << name;
  for (const char* name : {"K_csr.npz", "K_csc.npz", "K_coo.npz", "stored.npz:K", "deflated.npz:stiffness", "scipy_v5.mat:K",
                           "scipy_v4.mat:K", "scipy_compressed.mat:Stiff", "K_scipy.hb", "K_numpy.csv", "K_numpy.txt"})
    EXPECT_EQ(the_one(name), stiffness) << name;
  for (const char* name : {"stored.npz:G", "scipy_v5.mat:G", "G_scipy.mtx"}) EXPECT_EQ(the_one(name), gyroscopic) << name;
  EXPECT_EQ(the_one("lumped.npy"), (Matrix{{1}, {2}, {3}}));
}

TEST(MatrixFiles, OfOctave) {
  for (const char* version : {"octave_v4.mat", "octave_v6.mat", "octave_v7.mat"}) {
    const std::string file = version;
    EXPECT_TRUE(the_one(file + ":M") == mass && the_one(file + ":G") == gyroscopic && the_one(file + ":K") == stiffness) << file;
  }
  EXPECT_EQ(the_one("octave_sparse.mat:S"), stiffness);
}

TEST(MatrixFiles, WhatIsNoRealMatrixIsNamed) {
  EXPECT_EQ(refusal_of("complex.npy"), "complex.npy: the NumPy array is complex: a matrix of real numbers was expected");
  EXPECT_EQ(refusal_of("cube.npy"), "cube.npy: the NumPy array has 3 dimensions: a matrix of real numbers was expected");
  EXPECT_NE(refusal_of("objects.npy").find("real numbers"), std::string::npos);
  EXPECT_NE(refusal_of("K_dia.npz").find("csr, csc or coo was expected (A.tocsr() before save_npz)"), std::string::npos);
  EXPECT_EQ(refusal_of("stored.npz"), "stored.npz: holds 3 matrices (G, K, M): one was expected, chosen as stored.npz:NAME");
  EXPECT_EQ(refusal_of("stored.npz:Q"), "stored.npz: holds no matrix 'Q': it has G, K, M");
}

// v7.3 is HDF5, as MATLAB writes large files; libmatio writes it.
TEST(MatrixFiles, OfMatlab73) {
  const fs::path file = fs::path(testing::TempDir()) / "gyromode_v73.mat";
  mat_t* mat = Mat_CreateVer(file.string().c_str(), nullptr, MAT_FT_MAT73);
  ASSERT_NE(mat, nullptr);
  std::size_t dims[2] = {3, 3};
  matvar_t* v = Mat_VarCreate("K", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, dims, const_cast<double*>(stiffness.data()), 0);
  EXPECT_EQ(Mat_VarWrite(mat, v, MAT_COMPRESSION_NONE), 0);
  Mat_VarFree(v);
  Mat_Close(mat);
  EXPECT_EQ(chosen_matrix(read_matrices_of(file), {file, "K"}).matrix, stiffness);
  fs::remove(file);
}

TEST(MatrixFiles, WhatIsWrittenReadsBackTheSame) {
  std::mt19937_64 bits(3);
  const fs::path file = fs::path(testing::TempDir()) / "gyromode_round.mat";
  for (const Index n : {1, 2, 17}) {
    Matrix a(n, n);
    for (double& x : a.reshaped()) {  // every kind of double
      do {
        const std::uint64_t b = bits();
        std::memcpy(&x, &b, sizeof x);
      } while (!std::isfinite(x));
    }
    EXPECT_EQ(parsed(io::format_npy(a)), a);
    const auto several = parse_matrices(io::format_npz({{"M", a, {}}, {"K", 2 * stiffness, {}}}), "x.npz", std::nullopt);
    EXPECT_TRUE(several.size() == 2 && several[0].name == "K" && several[0].matrix == 2 * stiffness && several[1].matrix == a);
    EXPECT_EQ(parsed(io::format_number_table(a)), a);
    io::write_matlab(file, {{"M", a, {}}});
    EXPECT_EQ(chosen_matrix(read_matrices_of(file), {file, "M"}).matrix, a);
  }
  fs::remove(file);
}

// ---- Harwell–Boeing

const std::string hb =
    "Stiffness of three                                                      STIF    \n"
    "             4             1             1             2             0\n"
    "RSA                        3             3             5             0\n"
    "(8I10)          (8I10)          (1P,3D24.16)        \n"
    "         1         3         5         6\n"
    "         1         2         2         3         3\n"
    "  1.0000000000000000D+01 -1.0000000000000000D+00  2.0500000000000000D+01\n"
    " -1.0000000000000001D-01  3.0000000000000000D+01\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(HarwellBoeing, SymmetricSkewAndRutherford) {
  EXPECT_EQ(parsed(hb), stiffness);
  EXPECT_EQ(parse_matrices(hb, "x.hb").front().name, "STIF");
  const Matrix skew = parsed(
      "Gyroscopic                                                              G       \n"
      "             3             1             1             1\n"
      "rza                        3             3             3             0\n"
      "(4I8)           (3I8)           (3E15.7)            \n"
      "       1       3       4       4\n"
      "       2       3       3\n"
      " -1.5000000E+00  2.0000000E+00 -1.2500000E-01\n");
  EXPECT_EQ(skew, gyroscopic);
  std::string crlf;
  for (const char c : hb) crlf += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(parsed(crlf), stiffness);
}

TEST(HarwellBoeing, Refusals) {
  expect_refused(with(hb, "RSA", "PSA"), "the pattern of a matrix, and no values");
  expect_refused(with(hb, "RSA", "CSA"), "the matrix is complex");
  expect_refused(with(hb, "RSA", "RSE"), "given by elements");
  expect_refused(with(hb, "(1P,3D24.16)", "(FREE FORMAT)"), "the format of values is '(FREE FORMAT)'");
  expect_refused(with(hb, "         2         2         3", "         2         4         3"), "row index 4 is outside the matrix");
  expect_refused(with(hb, "         1         3         5         6", "         1         5         3         6"),
                 "pointers do not ascend");
  expect_refused(hb.substr(0, hb.size() - 50), "the file ends where value 4 of 5 was expected");
  expect_refused(with(hb, "2.0500000000000000D+01", "2.05000000x0000000D+01"), "value 3 is");
  expect_refused(with(hb, "         2         2         3", "         1         2         3"), "entry (1,1) is given twice");
}

// ---- Nastran DMIG

TEST(Dmig, SmallLargeAndFreeField) {
  const Matrix expected{{10, -1, 0}, {-1, 20.5, -.1}, {0, -.1, 30}};
  const std::string small =
      "$ stiffness\n"
      "DMIG    K       0       6       1       0                       3\n"
      "DMIG    K       1       1               1       1       10.             \n"
      "        1       2       -1.0\n"
      "DMIG    K       1       2               1       2       2.05+1          \n"
      "        7               -1.-1\n"
      "DMIG    K       7                       7               3.+1\n";
  const std::string large =
      "DMIG    K              0       6       2       0                       3\n"
      "DMIG*   K                              1               1                \n"
      "*                      1               1 1.000000000D+01\n"
      "DMIG*   K                              1               2                \n"
      "*                      1               1-1.000000000D+00\n"
      "*                      1               2 2.050000000D+01\n"
      "DMIG*   K                              7                                \n"
      "*                      1               2-1.000000000D-01\n"
      "*                      7                 3.000000000D+01\n";
  const std::string free =
      "DMIG,K,0,6,2,0\nDMIG,K,1,1,,1,1,10.0\n,1,2,-1.\nDMIG,K,1,2,,1,2,20.5,,\n,7,,-0.1\nDMIG,K,7,0,,7,0,30.\nENDDATA\n";
  for (const std::string& text : {small, large, free}) {
    const auto all = parse_matrices(text, "K.pch");
    ASSERT_EQ(all.size(), 1U) << text;
    EXPECT_EQ(all.front().matrix, expected) << text;
    EXPECT_EQ(all.front().labels, (Labels{"1.1", "1.2", "7"})) << text;
  }
}

TEST(Dmig, MatricesHaveTheirOwnDegreesOfFreedom) {
  const auto all = parse_matrices("DMIG,M,0,6,2,0\nDMIG,M,2,1,,2,1,5.\nDMIG,G,0,1,2,0\nDMIG,G,1,1,,2,1,-3.\nDMIG,G,2,1,,1,1,3.\n", "x.pch");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_TRUE(all[0].name == "M" && all[0].matrix == Matrix{{5}} && all[0].labels == Labels{"2.1"});
  EXPECT_TRUE(all[1].name == "G" && all[1].matrix == (Matrix{{0, 3}, {-3, 0}}));
}

TEST(Dmig, Refusals) {
  expect_refused("DMIG,K,0,6,3,0\n", "'K' is complex");
  expect_refused("DMIG,K,0,5,2,0\n", "form '5' of 'K'");
  expect_refused("DMIG,K,1,1,,1,1,2.\n", "'K' has no header before its columns");
  expect_refused("DMIG,K,0,6,2,0\nDMIG,K,1,1,,1,1,2x\n", "the term '1 1 2x' of 'K'");
  expect_refused("DMIG,K,0,6,2,0\nDMIG,K,1,1,,1,1,2.\nDMIG,K,1,1,,1,1,3.\n", "entry (1,1) is given twice");
}

// ---- Nastran OUTPUT4

const std::string op4_dense =
    "       3       3       6       2K       1P,3E23.16                              \n"
    "       1       1       4\n"
    " 1.0000000000000000E+01-1.0000000000000000E+00\n"
    "       2       1       6\n"
    "-1.0000000000000000E+00 2.0500000000000000E+01-1.0000000000000001E-01\n"
    "       3       2       4\n"
    "-1.0000000000000001E-01 3.0000000000000000E+01\n"
    "       4       1       1\n"
    " 1.0000000000000000E+00\n";

TEST(Op4, Text) {
  EXPECT_EQ(parsed(op4_dense), stiffness);
  // Strings: L = 1 + words; header L · 65536 + row, with BIGMAT (rows written negative) L and row.
  const std::string values = " 1.0000000000000000E+01-1.0000000000000000E+00\n";
  const std::string sparse =
      "       3       3       6       2K       1P,3E23.16\n"
      "       1       0       5\n" +
      std::string("  327681\n") + values +
      "       2       0       7\n"
      "  458753\n"
      "-1.0000000000000000E+00 2.0500000000000000E+01-1.0000000000000001E-01\n"
      "       3       0       6\n"
      "  196610\n-1.0000000000000001E-01\n  196611\n 3.0000000000000000E+01\n"
      "       4       1       1\n 1.0000000000000000E+00\n";
  EXPECT_EQ(parsed(sparse), stiffness);
  const std::string big =
      "       3      -3       6       2K       1P,3E23.16\n"
      "       1       0       6\n       5       1\n" +
      values +
      "       2       0       8\n       7       1\n"
      "-1.0000000000000000E+00 2.0500000000000000E+01-1.0000000000000001E-01\n"
      "       3       0       6\n       5       2\n-1.0000000000000001E-01 3.0000000000000000E+01\n"
      "       4       1       1\n 1.0000000000000000E+00\n";
  EXPECT_EQ(parsed(big), stiffness);
  const auto two = parse_matrices(op4_dense + with(op4_dense, "2K ", "2M "), "x.op4");
  EXPECT_TRUE(two.size() == 2 && two[0].name == "K" && two[1].name == "M");
}

// Fortran records of either endian.
class Records {
 public:
  explicit Records(bool swapped) : swapped_(swapped) {}
  void record(const std::string& content) {
    put(static_cast<std::int32_t>(content.size()));
    bytes_ += content;
    put(static_cast<std::int32_t>(content.size()));
  }
  template <class T>
  std::string as_bytes(T value) const {
    std::string b(sizeof(T), '\0');
    std::memcpy(b.data(), &value, sizeof(T));
    if (swapped_) std::reverse(b.begin(), b.end());
    return b;
  }
  std::string whole(std::initializer_list<std::int32_t> values) const {
    std::string all;
    for (const std::int32_t v : values) all += as_bytes(v);
    return all;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void put(std::int32_t v) { bytes_ += as_bytes(v); }
  bool swapped_;
  std::string bytes_;
};

TEST(Op4, Binary) {
  for (const bool swapped : {false, true}) {
    Records dense(swapped), sparse(swapped), single(swapped);
    dense.record(dense.whole({3, 3, 6, 2}) + "K       ");
    sparse.record(sparse.whole({3, -3, 6, 2}) + "K       ");
    single.record(single.whole({3, 3, 6, 1}) + "M       ");
    for (std::int32_t j = 0; j < 3; ++j) {
      std::string column, strings, floats;
      for (Index i = 0; i < 3; ++i) {
        column += dense.as_bytes(stiffness(i, j));
        floats += single.as_bytes(static_cast<float>(mass(i, j)));
        if (stiffness(i, j) != 0) strings += sparse.whole({3, static_cast<std::int32_t>(i + 1)}) + sparse.as_bytes(stiffness(i, j));
      }
      dense.record(dense.whole({j + 1, 1, 6}) + column);
      single.record(single.whole({j + 1, 1, 3}) + floats);
      sparse.record(sparse.whole({j + 1, 0, static_cast<std::int32_t>(strings.size() / 4)}) + strings);
    }
    for (Records* r : {&dense, &sparse}) r->record(r->whole({4, 1, 1}) + r->as_bytes(1.0));
    single.record(single.whole({4, 1, 1}) + single.as_bytes(1.0F));
    EXPECT_EQ(parsed(dense.bytes()), stiffness) << swapped;
    EXPECT_EQ(parsed(sparse.bytes()), stiffness) << swapped;
    EXPECT_EQ(parsed(single.bytes()), mass) << swapped;
    for (const std::size_t cut : {std::size_t{33}, std::size_t{60}, dense.bytes().size() - 1})
      EXPECT_NE(refusal(dense.bytes().substr(0, cut)), "accepted") << cut;
  }
}

TEST(Op4, Refusals) {
  expect_refused(op4_dense.substr(0, op4_dense.find("       3       2       4")), "OUTPUT4: the file ends where");
  expect_refused(with(op4_dense, "6       2K", "6       4K"), "'K' is complex: a matrix of real numbers");
  expect_refused(with(op4_dense, "1P,3E23.16", "UNKNOWN   "), "the format of values is 'UNKNOWN'");
  expect_refused(with(op4_dense, "       2       1       6", "       2       2       6"), "rows 2 to 4 of column 2 are outside");
  expect_refused(with(op4_dense, "2.0500000000000000E+01", "2.0500x00000000000E+01"), "where a number 23 columns wide was expected");
}

// ---- tables of numbers

TEST(NumberTable, MarksLabelsAndByteOrder) {
  for (const char* text : {"1,2\n3,4\n", "1;2\n3;4", "1 2\n 3\t4\n",
                           "\xEF\xBB\xBF"
                           "1, 2\r\n3, 4\r\n",
                           "# K\n1,2 # first\n\n3,4\n", "x,y\n1,2\n3,4\n", ";x;y\nx;1;2\ny;3;4\n"})
    EXPECT_EQ(parsed(text), (Matrix{{1, 2}, {3, 4}})) << text;
  EXPECT_EQ(parse_matrices("\"x\",y\n1,2\n3,4\n", "K.csv").front().labels, (Labels{"x", "y"}));
  EXPECT_TRUE(parse_matrices("1,2\n3,4\n", "K.csv").front().labels.empty());
  expect_refused("1,2\n3\n", "K.dat:2: 1 numbers: 2 were expected, as in the first row");
  expect_refused("1,2\n3,four\n", "K.dat:2: 'four' is no finite number");
  expect_refused("1,2\n3,inf\n", "'inf' is no finite number");
  expect_refused("a,b\n", "has no numbers");
  expect_refused(std::string("\x7f"
                             "ELF\0\0",
                             6),
                 "is a binary file of no format that is read");
}

TEST(MatrixFiles, OrdersBeyondTheLimitAreRefusedBeforeMemoryIsTaken) {
  expect_refused("\x93NUMPY\x01" + std::string("\0\x46\0", 3) + "{'descr': '<f8', 'fortran_order': False, 'shape': (900000, 900000), }  \n",
                 "ends after 0 of");
  expect_refused(with(hb, "         3             3             5", "    900000        900000             5"),
                 "900000 × 900000 is too large");
  expect_refused(with(op4_dense, "       3       3       6", "  900000  900000       6"), "the file ends where");
}

}  // namespace
}  // namespace gyromode
