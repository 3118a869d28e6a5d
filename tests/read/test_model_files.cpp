// The files of a model: matrices and labels beside it, hashes, and files that cannot be read.
#include "gyromode/base/error.h"
#include "gyromode/base/quantity.h"
#include "gyromode/models/matrices.h"
#include "gyromode/read/read_model.h"
#include "read/model_folder.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gyromode::io {
namespace {

Matrix rows2(double a, double b, double c, double d) { return Matrix{{a, b}, {c, d}}; }

const System& second_order(const Model& model) { return *model.body->second_order(); }

using ModelFiles = ModelFolder;

TEST_F(ModelFiles, MatricesFromFilesBesideTheModel) {
  fs::create_directory(folder_ / "deep");
  write("deep/M.mtx", mtx_m);
  write("deep/G.mtx", mtx_g);
  write("K.mtx", mtx_k);
  const fs::path file = write("deep/model.toml", "kind = 'matrices'\nmass = 'M.mtx'\ngyroscopic = 'G.mtx'\nstiffness = '../K.mtx'\n");
  const Model model = read_model(file);
  EXPECT_EQ(second_order(model).mass(), rows2(2, 0, 0, 3));
  EXPECT_EQ(second_order(model).gyroscopic(), rows2(0, -4, 4, 0));
  EXPECT_EQ(second_order(model).stiffness(), rows2(5, -1, -1, 7));
}

TEST_F(ModelFiles, TextInMemoryIsReadAsTheFile) {
  write("K.mtx", mtx_k);
  const std::string text = "kind = 'matrices'\nmass = [[1, 0], [0, 1]]\nstiffness = 'K.mtx'\n";
  const Model from_file = read_model(write("name.of.model.toml", text));
  const Model from_text = parse_model(text, folder_ / "name.of.model.toml");
  EXPECT_EQ(from_text.title, "name.of.model");
  EXPECT_EQ(from_text.title, from_file.title);
  EXPECT_EQ(from_text.sha256, from_file.sha256);
  EXPECT_EQ(second_order(from_text).stiffness(), second_order(from_file).stiffness());
}

TEST_F(ModelFiles, MatrixFilesThatCannotBeRead) {
  const std::string start = "kind = 'matrices'\nmass = ";
  EXPECT_EQ(error(start + "'M.mtx'"), "model.toml:2:8: 'mass' names 'M.mtx', which does not exist: a matrix file was expected");
  EXPECT_EQ(error(start + "'no/where.mtx'"),
            "model.toml:2:8: 'mass' names 'no/where.mtx', which does not exist: a matrix file was expected");
  EXPECT_EQ(error(start + "'/no/where.mtx'"),
            "model.toml:2:8: 'mass' names '/no/where.mtx', which does not exist: a matrix file was expected");
  fs::create_directory(folder_ / "M.mtx");
  EXPECT_EQ(error(start + "'M.mtx'"), "M.mtx: is a directory: a matrix file was expected");
  write("bad.mtx", "%%MatrixMarket matrix array real general\n1 1\nx\n");
  EXPECT_EQ(error(start + "'bad.mtx'").find("bad.mtx:3: value 'x' is not a number"), 0u);
  write("wide.mtx", "%%MatrixMarket matrix array real general\n2 3\n1\n2\n3\n4\n5\n6\n");
  EXPECT_EQ(error(start + "'wide.mtx'"), "model.toml:2:8: 'mass' has 2 rows and 3 columns: a square matrix was expected");
  write("vector.mtx", "%%MatrixMarket matrix array real general\n1 2\n3\n4\n");
  EXPECT_EQ(second_order(read(start + "'vector.mtx'\nstiffness=[5,6]")).mass(), rows2(3, 0, 0, 4));
  // Large ones are held sparse, up to their promised end.
  write("large.mtx", "%%MatrixMarket matrix coordinate real general\n16384 16384 16384\n1 1 1\n");
  EXPECT_EQ(error(start + "'large.mtx'"), "large.mtx:3: the file ends after 1 of the 16384 entries that line 2 promises");
  write("large.mtx", "%%MatrixMarket matrix coordinate real symmetric\n16384 16384 1\n1 1 1\n2 2 1\n");
  EXPECT_EQ(error(start + "'large.mtx'"), "large.mtx:4: one entry more than the 1 that line 2 promises");
  write("largest.mtx", "%%MatrixMarket matrix coordinate real general\n4999 4999 16383\n1 1 1\n");
  EXPECT_EQ(error(start + "'largest.mtx'"), "largest.mtx:3: the file ends after 1 of the 16383 entries that line 2 promises");
  // Too large for a dense model: said at the size line, before its entries are read.
  write("large.mtx", "%%MatrixMarket matrix array real general\n20000 20000\n");
  EXPECT_EQ(error(start + "'large.mtx'"), "large.mtx:2: size 20000 x 20000 is too large: dense models have at most 16383 coordinates");
}

TEST_F(ModelFiles, ModelFilesThatCannotBeRead) {
  const auto of = [&](const fs::path& file) -> std::string {
    try {
      read_model(file);
    } catch (const Unreadable& e) {
      return without_folder(e.what());
    }
    return "(accepted)";
  };
  EXPECT_EQ(of(folder_ / "none.toml"), "none.toml: cannot be opened (No such file or directory): a TOML model file was expected");
  fs::create_directory(folder_ / "folder.toml");
  EXPECT_EQ(of(folder_ / "folder.toml"), "folder.toml: is a directory: a TOML model file was expected");
  EXPECT_EQ(error(""), "model.toml: is empty: a TOML model was expected");
  // What is no text is not read to its end, if it has one.
  EXPECT_EQ(of("/dev/zero"), "/dev/zero:1: byte '\\x00' is not text: this is a binary file, a TOML model file was expected");
  write("binary.toml", std::string("kind = 'matrices'\ntitle = '\0'\n", 31));
  EXPECT_EQ(of(folder_ / "binary.toml"), "binary.toml:2: byte '\\x00' is not text: this is a binary file, a TOML model file was expected");
}

TEST_F(ModelFiles, GarbageIsOneLineWithItsPlace) {
  EXPECT_EQ(error("kind = 'matrices'\nmass = [[1, 0\n").find("model.toml:2:"), 0u);
  for (const std::string& text :
       {std::string("kind = matrices"), std::string("kind"), std::string("= 1"), std::string("[known"), std::string("kind = 'a"),
        std::string("\xff\xfe"), std::string("kind = 'matrices'\nkind = 'matrices'"), std::string("mass = [[1 0]]"), std::string("[)"),
        std::string("é = 1"), std::string("a = { b = { c = [ { d = ")}) {
    const std::string message = error(text);
    EXPECT_EQ(message.find("model.toml:1:") == 0 || message.find("model.toml:2:") == 0, true) << message;
    EXPECT_NE(message.find(": is not TOML: "), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_EQ(
      error("%%MatrixMarket matrix array real general\n1 1\n1\n"),
      "model.toml: is a matrix file (Matrix Market), no model: --mass, --gyroscopic, --stiffness or --matrices was expected before it");
  EXPECT_EQ(error("kind='matrices'\nmass=[[{a=[[1]]}]]"), "model.toml:2:8: entry (1,1) of 'mass' is a table: a number was expected");
  EXPECT_EQ(error("kind='matrices'\nmass.rows=[[1]]"), "model.toml:2:1: 'mass' is a table: a matrix file or rows of numbers was expected");
  EXPECT_EQ(error("kind.of='matrices'").find("'kind' is a table: a string was expected") != std::string::npos, true);
}

// What nests without end is refused before anything is built of it: by parts of keys and of headers, by arrays, by
// inline tables, and by all of them together.
TEST_F(ModelFiles, NestingHasAnEnd) {
  const auto dotted = [](int parts) {
    std::string key = "a";
    for (int k = 1; k < parts; ++k) key += ".a";
    return key;
  };
  const auto times = [](int n, const std::string& piece) {
    std::string all;
    for (int k = 0; k < n; ++k) all += piece;
    return all;
  };
  const std::string beyond = "keys, tables and arrays are nested here beyond 64 levels: a flatter model was expected";
  for (const int n : {65, 1000, 100'000}) {
    EXPECT_EQ(error(dotted(n) + " = 1\n"), (n == 65 ? "model.toml:1:131: " : "model.toml:1:130: ") + beyond) << n;
    EXPECT_EQ(error("[" + dotted(n) + "]\nx = 1\n"), "model.toml:1:129: " + beyond) << n;
    EXPECT_EQ(error("kind = 'matrices'\n[[" + dotted(n) + "]]\n"), "model.toml:2:128: " + beyond) << n;
    EXPECT_EQ(error("a = " + times(n, "[")), "model.toml:1:68: " + beyond) << n;
    EXPECT_EQ(error("a = " + times(n, "{a=") + "1" + times(n, "}")), "model.toml:1:100: " + beyond) << n;
    EXPECT_EQ(error("a = " + times(n, "[\n")), "model.toml:64:1: " + beyond) << n;
  }
  // Each part by itself is short.
  EXPECT_NE(error("[" + dotted(30) + "]\n" + dotted(20) + " = {" + dotted(20) + " = 1}\n").find(beyond), std::string::npos);
  EXPECT_NE(error(times(40, "[" + dotted(20) + "]\n") + "x = " + times(5, "[{" + dotted(20) + "=")).find(beyond), std::string::npos);
  // Dots and brackets of strings and comments are none, whatever quotes they hold; and what is wide is not deep.
  for (const std::string& text : {"# " + dotted(1000) + times(1000, "[") + "\n", "title = \"\\\"" + times(1000, "[") + "\"\n",
                                  "title = '\\" + std::string("'") + "\nreference = '" + dotted(1000) + "'\n",
                                  "title = \"\"\"\n\"\" " + times(1000, "{\n") + "\"\"\"\"\"\n", "title = '''" + times(1000, "[") + "'''\n",
                                  "title = ''\nreference = \"\" # " + times(100, "[") + "\n"}) {
    EXPECT_EQ(error("kind = 'matrices'\n" + text + "mass = [[1]]\nstiffness = [[1]]\n"), "(accepted)") << text.substr(0, 40);
  }
  EXPECT_EQ(error("kind = 'matrices'\nmass = [[1]]\nstiffness = [[1]]\n[known]\nfrequencies = [" + times(1000, "1.0, ") + "1.0]\n"),
            "(accepted)");
}

TEST_F(ModelFiles, Sha256OfTheModelAndItsMatrices) {
  write("M.mtx", mtx_m);
  write("K.mtx", mtx_k);
  write("unused.mtx", mtx_g);
  const std::string text = "kind = 'matrices'\nmass = 'M.mtx'\nstiffness = 'K.mtx'\n";
  const std::string first = read(text).sha256;
  EXPECT_EQ(first.size(), 64u);
  EXPECT_EQ(first.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(read(text).sha256, first);
  write("unused.mtx", "another");
  EXPECT_EQ(read(text).sha256, first);
  EXPECT_EQ(read_model(write("other_name.toml", text)).sha256, first);

  write("K.mtx", std::string(mtx_k) + "% a comment is a change of bytes\n");
  const std::string second = read(text).sha256;
  EXPECT_NE(second, first);
  write("M.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2\n2 2 4\n");
  EXPECT_NE(read(text).sha256, second);
  EXPECT_NE(read(text).sha256, first);
  write("M.mtx", mtx_m);
  write("K.mtx", mtx_k);
  EXPECT_EQ(read(text).sha256, first);
  EXPECT_NE(read(text + "# comment\n").sha256, first);
}

TEST_F(ModelFiles, Sha256IsThatOfSha256sum) {
  // printf "kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\n" | sha256sum
  EXPECT_EQ(read("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\n").sha256,
            "73fd6080d87d573bc70ebe54857b596500040fe81be522644c6a1ae659d14e24");
  // The same of model, M, G, K, per-spin G, per-spin K: in the order of the laws, whatever that of the keys.
  for (const char* name : {"M", "K", "K2"}) write(std::string(name) + ".mtx", std::string(mtx_k) + "% " + name + "\n");
  for (const char* name : {"G", "G1"}) write(std::string(name) + ".mtx", std::string(mtx_g) + "% " + name + "\n");
  const std::string text =
      "stiffness_per_spin2='K2.mtx'\ngyroscopic_per_spin='G1.mtx'\nstiffness='K.mtx'\ngyroscopic='G.mtx'\nmass='M.mtx'\nspin=1\nkind='"
      "matrices'\n";
  EXPECT_EQ(read(text).sha256, "cb1335f2cb033befdec91919888ae46eebc2cf54cb713c90ce1620603f18531b");
}

TEST_F(ModelFiles, BytesToReadAreThoseOfTheFilesThatAModelNames) {
  const std::string text = "kind='matrices'\nmass='M.mtx'\nstiffness='K.mtx'\ngyroscopic='none.mtx'\n";
  const fs::path model = write("model.toml", text);
  write("M.mtx", std::string(1000, 'm'));
  const fs::path k = write("K.mtx", std::string(20, 'k'));
  EXPECT_EQ(bytes_to_read(model), text.size() + 1020);
  EXPECT_EQ(bytes_to_read(k), 20u);
  EXPECT_EQ(bytes_to_read(folder_), 0u);
  EXPECT_EQ(bytes_to_read(folder_ / "none.toml"), 0u);
  EXPECT_EQ(bytes_to_read(write("damaged.toml", "mass = [")), 8u) << "whoever reads it will say";
}

// Labels from a file, or those that the matrix files have for their rows.
TEST_F(ModelFiles, LabelsFromFiles) {
  const std::string start = "kind='matrices'\nmass=[[1,0],[0,1]]\nstiffness=[[1,0],[0,1]]\n";
  write("names.txt", "\xEF\xBB\xBF# of the hub\nhub x\n\n\"hub, y\"\n");
  EXPECT_EQ(read(start + "labels='names.txt'").labels(), (Labels{"hub x", "hub, y"}));
  write("names.txt", "x;y\n");
  EXPECT_EQ(read(start + "labels='names.txt'").labels(), (Labels{"x", "y"}));
  write("names.txt", "x\nx\n");
  EXPECT_EQ(error(start + "labels='names.txt'"), "names.txt:2: label 'x' is given a second time (first on line 1)");
  write("names.txt", "x\n");
  EXPECT_EQ(error(start + "labels='names.txt'"), "model.toml:4:8: 'labels' has 1 names: 2 were expected, one a coordinate");
  EXPECT_EQ(error(start + "labels='none.txt'").substr(0, 9), "none.txt:");

  write("M.pch", "DMIG,M,0,6,2,0\nDMIG,M,7,1,,7,1,2.\nDMIG,M,7,2,,7,2,3.\n");
  write("K.pch", "DMIG,K,0,6,2,0\nDMIG,K,7,1,,7,1,5.\nDMIG,K,8,2,,8,2,6.\n");
  EXPECT_EQ(read("kind='matrices'\nmass='M.pch'\nstiffness=[5,6]").labels(), (Labels{"7.1", "7.2"}));
  EXPECT_EQ(read("kind='matrices'\nmass='M.pch'\nlabels=['a','b']").labels(), (Labels{"a", "b"}));
  EXPECT_EQ(error("kind='matrices'\nmass='M.pch'\nstiffness='K.pch'").substr(0, 75),
            "model.toml:3:11: the rows of 'stiffness' have other names, or another order");
}

}  // namespace
}  // namespace gyromode::io
