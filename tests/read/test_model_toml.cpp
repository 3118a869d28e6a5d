#include "gyromode/base/error.h"
#include "gyromode/read/read_model.h"
#include "gyromode/base/quantity.h"
#include "gyromode/models/matrices.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gyromode::io {
namespace {

namespace fs = std::filesystem;

Matrix rows2(double a, double b, double c, double d) { return Matrix{{a, b}, {c, d}}; }

const System& second_order(const Model& model) { return *model.body->second_order(); }

// A folder of its own for each test, with the models and matrices it writes.
class ModelToml : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = (fs::temp_directory_path() / "gyromode-model-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path write(const std::string& name, std::string_view text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }

  Model read(std::string_view text) const { return read_model(write("model.toml", text)); }

  // The message of an Unreadable, names without the folder.
  std::string error(std::string_view text) const {
    try {
      read(text);
    } catch (const Unreadable& e) {
      return without_folder(e.what());
    }
    return "(accepted)";
  }

  std::string broken(std::string_view text) const {
    try {
      read(text);
    } catch (const LawBroken& e) {
      return e.what();
    }
    return "(accepted)";
  }

  std::string without_folder(std::string message) const {
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = message.find(prefix); at != std::string::npos; at = message.find(prefix)) message.erase(at, prefix.size());
    return message;
  }

  fs::path folder_;
};

constexpr const char* mtx_m = "%%MatrixMarket matrix coordinate real symmetric\n2 2 2\n1 1 2\n2 2 3\n";
constexpr const char* mtx_g = "%%MatrixMarket matrix coordinate real skew-symmetric\n2 2 1\n2 1 4\n";
constexpr const char* mtx_k = "%%MatrixMarket matrix array real symmetric\n2 2\n5\n-1\n7\n";

TEST_F(ModelToml, SecondOrderInline) {
  const Model model = read(R"(kind = "matrices"
title = "Two masses"
reference = "nobody 1999"
labels = ["x", "y ü"]
mass = [[2, 0], [0, 2.5]]
gyroscopic = [[0, -4], [4, 0]]
stiffness = [[0x10, 0.5], [0.5, 1_000]]
[known]
frequencies = [0.5, 2]
stability = "stable"
class = "general"
)");
  EXPECT_EQ(model.kind, "matrices");
  EXPECT_EQ(model.title, "Two masses");
  EXPECT_EQ(model.reference, "nobody 1999");
  EXPECT_EQ(model.size(), 2);
  EXPECT_EQ(model.labels(), (Labels{"x", "y ü"}));
  EXPECT_FALSE(model.spin);
  EXPECT_EQ(second_order(model).mass(), rows2(2, 0, 0, 2.5));
  EXPECT_EQ(second_order(model).gyroscopic(), rows2(0, -4, 4, 0));
  EXPECT_EQ(second_order(model).stiffness(), rows2(16, .5, .5, 1000));
  EXPECT_EQ(model.known.frequencies, (std::vector<double>{0.5, 2}));
  EXPECT_EQ(model.known.stability, "stable");
  EXPECT_EQ(model.known.system_class, "general");
}

TEST_F(ModelToml, Defaults) {
  const Model model = read("kind = 'matrices'\r\nmass = [[1, 0], [0, 1]]\r\nstiffness = [[1, 0], [0, 1]]\r\n");
  EXPECT_EQ(model.title, "model");
  EXPECT_EQ(model.reference, "");
  EXPECT_EQ(model.labels(), (Labels{"q1", "q2"}));
  EXPECT_EQ(second_order(model).gyroscopic(), Matrix::Zero(2, 2));
  EXPECT_TRUE(model.known.frequencies.empty());
  EXPECT_EQ(model.known.stability, "");
  EXPECT_EQ(model.known.system_class, "");
}

TEST_F(ModelToml, FirstOrder) {
  write("I.mtx", mtx_m);
  const Model model = read("kind = 'first_order'\ninertia = 'I.mtx'\ngyroscopic = [[0, 1.5], [-1.5, 0]]\n");
  const auto& system = dynamic_cast<const FirstOrderModel&>(*model.body).system();
  EXPECT_EQ(model.kind, "first_order");
  EXPECT_EQ(model.size(), 2);
  EXPECT_EQ(model.labels(), (Labels{"q1", "q2"}));
  EXPECT_EQ(system.inertia(), rows2(2, 0, 0, 3));
  EXPECT_EQ(system.gyroscopic(), rows2(0, 1.5, -1.5, 0));
}

TEST_F(ModelToml, MatricesFromFilesBesideTheModel) {
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

TEST_F(ModelToml, TextInMemoryIsReadAsTheFile) {
  write("K.mtx", mtx_k);
  const std::string text = "kind = 'matrices'\nmass = [[1, 0], [0, 1]]\nstiffness = 'K.mtx'\n";
  const Model from_file = read_model(write("name.of.model.toml", text));
  const Model from_text = parse_model(text, folder_ / "name.of.model.toml");
  EXPECT_EQ(from_text.title, "name.of.model");
  EXPECT_EQ(from_text.title, from_file.title);
  EXPECT_EQ(from_text.sha256, from_file.sha256);
  EXPECT_EQ(second_order(from_text).stiffness(), second_order(from_file).stiffness());
}

TEST_F(ModelToml, SpinLaws) {
  const std::string laws = R"(kind = "matrices"
mass = [[1, 0], [0, 1]]
gyroscopic = [[0, -1], [1, 0]]
gyroscopic_per_spin = [[0, -3], [3, 0]]
stiffness = [[10, 2], [2, 20]]
stiffness_per_spin2 = [[-1, 0.5], [0.5, 4]]
spin = )";
  for (const auto& [written, spin] :
       std::vector<std::pair<std::string, double>>{{"2", 2}, {"-0.5", -0.5}, {"0", 0}, {"'1.5 rad/s'", 1.5}, {"'-4 1/s'", -4}}) {
    const Model model = read(laws + written);
    EXPECT_EQ(model.spin, spin) << written;
    const double g = 1 + 3 * spin, s = spin * spin;
    EXPECT_EQ(second_order(model).gyroscopic(), rows2(0, -g, g, 0)) << written;
    EXPECT_EQ(second_order(model).stiffness(), rows2(10 - s, 2 + 0.5 * s, 2 + 0.5 * s, 20 + 4 * s)) << written;
  }
}

TEST_F(ModelToml, SpinLawsWithoutTheConstantPart) {
  const Model g = read("kind='matrices'\nspin=2\nmass=[[1,0],[0,1]]\nstiffness=[[1,0],[0,1]]\ngyroscopic_per_spin=[[0,-3],[3,0]]");
  EXPECT_EQ(second_order(g).gyroscopic(), rows2(0, -6, 6, 0));
  EXPECT_EQ(second_order(g).stiffness(), rows2(1, 0, 0, 1));
  const Model k = read("kind='matrices'\nspin='60 rpm'\nmass=[[1,0],[0,1]]\nstiffness_per_spin2=[[2,0],[0,-1]]");
  const double spin = *k.spin;
  EXPECT_DOUBLE_EQ(spin, 6.283185307179586);
  EXPECT_EQ(second_order(k).stiffness(), rows2(spin * spin * 2, 0, 0, -(spin * spin)));
  EXPECT_EQ(second_order(k).gyroscopic(), Matrix::Zero(2, 2));
}

TEST_F(ModelToml, SpinNeedsWhatItActsOnAndTheReverse) {
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\nspin = 2\n"),
            "model.toml:4:8: 'spin' has nothing to act on: 'gyroscopic_per_spin' or 'stiffness_per_spin2' was expected beside it");
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\ngyroscopic_per_spin = [[0]]\n"),
            "model.toml:4:23: 'gyroscopic_per_spin' needs 'spin' = a frequency");
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness_per_spin2 = [[1]]\n"),
            "model.toml:3:23: 'stiffness_per_spin2' needs 'spin' = a frequency");
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nspin=1\ngyroscopic_per_spin=[[0]]\n"), "(accepted)");
}

TEST_F(ModelToml, KnownValuesAreCheckedWhereTheyStand) {
  const std::string start = "kind = 'matrices'\n";
  const std::string model = start + "mass = [[1]]\nstiffness = [[1]]\n[known]\n";
  EXPECT_EQ(error(model + "stability = \"stabel\"\n"),
            "model.toml:5:13: 'stabel' is no stability: stable, gyroscopically_stabilised, marginal, unstable was expected");
  EXPECT_EQ(error(model + "class = \"special\"\n"),
            "model.toml:5:9: 'special' is no class: quadrature, hidden_quadrature, general, transcendental was expected");
  EXPECT_EQ(error(model + "frequencies = [2, 1]\n"),
            "model.toml:5:15: 'frequencies' do not ascend: rad/s in ascending order were expected");
  EXPECT_EQ(error(model + "frequency = [1]\n"), "model.toml:5:1: key 'frequency' is not known here: did you mean 'frequencies'?");
}

TEST_F(ModelToml, LabelsPrintOnOneLine) {
  const std::string start = "kind = 'matrices'\n";
  EXPECT_EQ(error(start + "labels = [\"a\\nb\"]\nmass = [[1]]\nstiffness = [[1]]\n"),
            "model.toml:2:10: label 1, 'a\\x0ab', has a control character: a name that prints on one line was expected");
}

TEST_F(ModelToml, UnknownKeys) {
  const std::string start = "kind = 'matrices'\n";
  EXPECT_EQ(error(start + "stifness = [[1]]\n"), "model.toml:2:1: key 'stifness' is not known here: did you mean 'stiffness'?");
  EXPECT_EQ(error(start + "  Mass = [[1]]\n"), "model.toml:2:3: key 'Mass' is not known here: did you mean 'mass'?");
  EXPECT_EQ(error(start + "lables = []\n"), "model.toml:2:1: key 'lables' is not known here: did you mean 'labels'?");
  EXPECT_EQ(error(start + "[knwon]\n"), "model.toml:2:2: key 'knwon' is not known here: did you mean 'known'?");
  EXPECT_EQ(error(start + "inertia = [[1]]\n").find("model.toml:2:1: key 'inertia' is not known here: did you mean '"), 0u);
  EXPECT_EQ(error("kind = 'first_order'\nstiffness = [[1]]\n").find("model.toml:2:1: key 'stiffness' is not known here: one of "), 0u);
  EXPECT_EQ(error(start + "\"\\u001b[31m\" = 1\n").find("model.toml:2:1: key '\\x1b[31m' is not known here"), 0u);
}

TEST_F(ModelToml, Kinds) {
  const std::string expected = "model.toml:1: key 'kind' is missing: kind = \"matrices\", \"first_order\" or \"spacecraft\" was expected";
  EXPECT_EQ(error("title = 't'\n"), expected);
  EXPECT_EQ(error("# nothing\n"), expected);
  EXPECT_EQ(error("kind = ''\n"), expected);
  EXPECT_EQ(error("\nkind = 'rotor'\n"),
            "model.toml:2:8: kind 'rotor' is not known to this version: 'matrices', 'first_order' or 'spacecraft' was expected");
  EXPECT_EQ(error("kind = 'Matrices'\n"),
            "model.toml:1:8: kind 'Matrices' is not known to this version: 'matrices', 'first_order' or 'spacecraft' was expected");
  EXPECT_EQ(error("kind = 1\n"), "model.toml:1:8: 'kind' is a number: a string was expected");
}

TEST_F(ModelToml, MissingKeys) {
  EXPECT_EQ(error("kind='matrices'\nstiffness=[[1]]\n"),
            "model.toml:1: key 'mass' is missing: a matrix file or rows of numbers was expected");
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\n"), "(accepted)");
  EXPECT_EQ(error("kind='first_order'\ngyroscopic=[[0]]\n"),
            "model.toml:1: key 'inertia' is missing: a matrix file or rows of numbers was expected");
  EXPECT_EQ(error("kind='first_order'\ninertia=[[1]]\n"),
            "model.toml:1: key 'gyroscopic' is missing: a matrix file or rows of numbers was expected");
}

TEST_F(ModelToml, WrongTypes) {
  const std::vector<std::pair<std::string, std::string>> others{
      {"true", "true or false"}, {"{}", "a table"}, {"1979-05-27", "a date or time"}};
  for (const auto& [value, word] : others) {
    for (const char* key : {"title", "reference"}) {
      const std::string text = std::string("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\n") + key + "=" + value;
      EXPECT_EQ(error(text),
                "model.toml:4:" + std::to_string(std::string(key).size() + 2) + ": '" + key + "' is " + word + ": a string was expected");
    }
    EXPECT_EQ(error("kind='matrices'\nlabels=" + value), "model.toml:2:8: 'labels' is " + word + ": an array of strings was expected");
    EXPECT_EQ(error("kind='matrices'\nlabels=['x', " + value + "]"),
              "model.toml:2:14: an item of 'labels' is " + word + ": a string was expected");
    EXPECT_EQ(error("kind='matrices'\nmass=" + value),
              "model.toml:2:6: 'mass' is " + word + ": a matrix file or rows of numbers was expected");
    EXPECT_EQ(error("kind='matrices'\nmass=[[1,0],[" + value + ",1]]"),
              "model.toml:2:14: entry (2,1) of 'mass' is " + word + ": a number was expected");
    EXPECT_EQ(error("kind='matrices'\nmass=[[1,0]," + value + "]"),
              "model.toml:2:13: row 2 of 'mass' is " + word + ": an array of numbers was expected");
    for (const char* key : {"gyroscopic", "stiffness", "gyroscopic_per_spin", "stiffness_per_spin2"}) {
      const std::string text = std::string("kind='matrices'\nmass=[[1]]\n") + key + "=" + value;
      EXPECT_EQ(error(text), "model.toml:3:" + std::to_string(std::string(key).size() + 2) + ": '" + key + "' is " + word +
                                 ": a matrix file or rows of numbers was expected");
    }
    EXPECT_EQ(error("kind='first_order'\ninertia=" + value),
              "model.toml:2:9: 'inertia' is " + word + ": a matrix file or rows of numbers was expected");
    EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nspin=" + value),
              "model.toml:3:6: 'spin' is " + word + ": " + std::string(frequency_form) + " was expected");
  }
  EXPECT_EQ(error("kind='matrices'\nmass=1"), "model.toml:2:6: 'mass' is a number: a matrix file or rows of numbers was expected");
  EXPECT_EQ(error("kind='matrices'\nmass=[['one']]"),
            "model.toml:2:8: entry (1,1) of 'mass' = \"one\": 'one' is no parameter; [parameters] are none");
  EXPECT_EQ(error("kind='matrices'\nlabels='x'"), "model.toml:2:8: 'labels' is a string: an array of strings was expected");
  EXPECT_EQ(error("kind='matrices'\nlabels=[1]"), "model.toml:2:9: an item of 'labels' is a number: a string was expected");
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\ntitle=['a']"),
            "model.toml:4:7: 'title' is an array: a string was expected");
}

TEST_F(ModelToml, SpinThatIsNoFrequency) {
  const std::string start = "kind='matrices'\nmass=[[1]]\nstiffness_per_spin2=[[1]]\nspin=";
  for (const char* written : {"", "fast", "10 turns", "inf", "1e999 Hz", "1 HZ"}) {
    EXPECT_EQ(error(start + "'" + written + "'"), std::string("model.toml:4:6: 'spin' = \"") + written +
                                                      "\" is no frequency: " + std::string(frequency_form) + " was expected");
  }
  EXPECT_EQ(error(start + "inf"), "model.toml:4:6: 'spin' is inf: a finite number was expected");
  EXPECT_EQ(error(start + "-nan").find("model.toml:4:6: 'spin' is "), 0u);
  EXPECT_EQ(broken(start + "1e200"), "K must be finite: entry (1,1) = inf");
}

TEST_F(ModelToml, Shapes) {
  const std::string start = "kind='matrices'\n";
  EXPECT_EQ(error(start + "mass = [[1, 0], [0]]\n"), "model.toml:2:17: row 2 of 'mass' has 1 numbers: 2 were expected, as in row 1");
  EXPECT_EQ(error(start + "mass = [\n  [1, 0],\n  [0, 1, 2],\n]\n"),
            "model.toml:4:3: row 2 of 'mass' has 3 numbers: 2 were expected, as in row 1");
  EXPECT_EQ(error(start + "mass = [[1, 0], []]\n"), "model.toml:2:17: row 2 of 'mass' has 0 numbers: 2 were expected, as in row 1");
  EXPECT_EQ(error(start + "mass = [[1, 2]]\n"), "model.toml:2:8: 'mass' has 1 rows and 2 columns: a square matrix was expected");
  EXPECT_EQ(error(start + "mass = [[1], [2]]\n"), "model.toml:2:8: 'mass' has 2 rows and 1 columns: a square matrix was expected");
  for (const char* nothing : {"[]", "[[]]", "[[], []]"}) {
    EXPECT_EQ(error(start + "mass = " + nothing), "model.toml:2:8: 'mass' has no rows: [[…], […]] was expected") << nothing;
  }
  EXPECT_EQ(error(start + "mass = [1, 2]\n"), "(accepted)");  // a diagonal
  EXPECT_EQ(error(start + "mass = [1, [2]]\n").find("model.toml:2:12: number 2 of the diagonal 'mass'"), 0u);
  EXPECT_EQ(error(start + "mass = [[[1]]]\n"), "model.toml:2:10: entry (1,1) of 'mass' is an array: a number was expected");
}

TEST_F(ModelToml, OneOrderThroughout) {
  const std::string two = "[[1, 0], [0, 1]]";
  const std::string order = " is 2 × 2: the order of the matrices before it, 1 × 1, was expected";
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness=" + two), "model.toml:3:11: 'stiffness'" + order);
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\ngyroscopic=" + two), "model.toml:4:12: 'gyroscopic'" + order);
  EXPECT_EQ(error("kind='matrices'\nspin=1\nmass=[[1]]\nstiffness=[[1]]\ngyroscopic_per_spin=" + two),
            "model.toml:5:21: 'gyroscopic_per_spin'" + order);
  EXPECT_EQ(error("kind='matrices'\nspin=1\nmass=[[1]]\nstiffness_per_spin2=" + two), "model.toml:4:21: 'stiffness_per_spin2'" + order);
  EXPECT_EQ(error("kind='first_order'\ninertia=[[1]]\ngyroscopic=" + two), "model.toml:3:12: 'gyroscopic'" + order);
  write("K.mtx", mtx_k);
  EXPECT_EQ(error("kind='matrices'\nmass=[[1]]\nstiffness='K.mtx'"), "model.toml:3:11: 'stiffness'" + order);
}

TEST_F(ModelToml, EntriesAreFinite) {
  EXPECT_EQ(error("kind='matrices'\nmass=[[1, 0],\n[0, inf]]"),
            "model.toml:3:5: entry (2,2) of 'mass' is inf: a finite number was expected");
  EXPECT_EQ(error("kind='matrices'\nmass=[[-inf]]"), "model.toml:2:8: entry (1,1) of 'mass' is -inf: a finite number was expected");
  EXPECT_EQ(error("kind='matrices'\nmass=[[nan]]"), "model.toml:2:8: entry (1,1) of 'mass' is nan: a finite number was expected");
  EXPECT_NE(error("kind='matrices'\nmass=[[1e999]]\nstiffness=[[1]]"), "(accepted)");
}

TEST_F(ModelToml, MatrixFilesThatCannotBeRead) {
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
  write("wide.mtx", "%%MatrixMarket matrix array real general\n1 2\n1\n2\n");
  EXPECT_EQ(error(start + "'wide.mtx'"), "model.toml:2:8: 'mass' has 1 rows and 2 columns: a square matrix was expected");
  // Too large for a dense model: said at the size line, before its entries are read.
  write("large.mtx", "%%MatrixMarket matrix coordinate real general\n16384 16384 16384\n1 1 1\n");
  EXPECT_EQ(error(start + "'large.mtx'"), "large.mtx:2: size 16384 x 16384 is too large: dense models have at most 16383 coordinates");
  write("largest.mtx", "%%MatrixMarket matrix coordinate real general\n16383 16383 16383\n1 1 1\n");
  EXPECT_EQ(error(start + "'largest.mtx'"), "largest.mtx:3: the file ends after 1 of the 16383 entries that line 2 promises");
  write("large.mtx", "%%MatrixMarket matrix array real general\n20000 20000\n");
  EXPECT_EQ(error(start + "'large.mtx'"), "large.mtx:2: size 20000 x 20000 is too large: dense models have at most 16383 coordinates");
}

TEST_F(ModelToml, ModelFilesThatCannotBeRead) {
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

TEST_F(ModelToml, GarbageIsOneLineWithItsPlace) {
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
TEST_F(ModelToml, NestingHasAnEnd) {
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

TEST_F(ModelToml, KnownTable) {
  const std::string start = "kind='matrices'\nmass=[[1]]\nstiffness=[[1]]\n";
  const auto says = [&](const std::string& text, const std::string& end) {
    const std::string message = error(start + text);
    EXPECT_EQ(message.find("model.toml:"), 0u) << message;
    EXPECT_NE(message.find(end), std::string::npos) << message;
  };
  EXPECT_EQ(error(start + "known = 1\n"), "model.toml:4:9: 'known' is a number: a table [known] was expected");
  EXPECT_EQ(error(start + "known = []\n"), "model.toml:4:9: 'known' is an array: a table [known] was expected");
  says("[[known]]\n", "'known' is an array: a table [known] was expected");
  says("[known]\nfrequences = [1]\n", "key 'frequences' is not known here: did you mean 'frequencies'?");
  says("[known]\nfrequencies = 1\n", "'frequencies' is a number: an array of numbers was expected");
  says("[known]\nfrequencies = ['1 Hz']\n", "an item of 'frequencies' is a string: a number was expected");
  says("[known]\nfrequencies = [inf]\n", "an item of 'frequencies' is inf: a finite number was expected");
  says("[known]\nstability = true\n", "'stability' is true or false: a string was expected");
  says("[known]\nclass = 2\n", "'class' is a number: a string was expected");
  EXPECT_NO_THROW(read(start + "[known]\n"));
}

TEST_F(ModelToml, LabelsNameEveryCoordinateOnce) {
  const std::string start = "kind='matrices'\nmass=[[1,0],[0,1]]\nstiffness=[[1,0],[0,1]]\n";
  EXPECT_EQ(error(start + "labels=['x']\n"), "model.toml:4:8: 'labels' has 1 names: 2 were expected, one a coordinate");
  EXPECT_EQ(error(start + "labels=['x','y','z']\n"), "model.toml:4:8: 'labels' has 3 names: 2 were expected, one a coordinate");
  EXPECT_EQ(error(start + "labels=['x','x']\n"), "model.toml:4:8: label 'x' is given twice: different names were expected");
  EXPECT_EQ(error(start + "labels=['x','']\n"), "model.toml:4:8: label 2 is empty: a name was expected");
  EXPECT_EQ(error("kind='first_order'\nlabels=['x']\ninertia=[[1,0],[0,1]]\ngyroscopic=[[0,1],[-1,0]]\n"),
            "model.toml:2:8: 'labels' has 1 names: 2 were expected, one a coordinate");
}

TEST_F(ModelToml, BrokenPromises) {
  const std::string start = "kind='matrices'\nmass=[[1,0],[0,1]]\nstiffness=[[1,0],[0,1]]\n";
  EXPECT_EQ(broken(start + "gyroscopic=[[0,3],[-2.5,0]]\n"),
            "G must satisfy G = −Gᵀ: entries (1,2) = 3 and (2,1) = -2.5 miss opposite signs by 0.5, 17 % of the largest entry; its "
            "symmetric part acts as damping of both signs, as flow at a "
            "free end does, which is not served; --symmetrise=0.2 (key symmetrise) uses the skew part");
  EXPECT_EQ(broken("kind='matrices'\nmass=[[1,2],[0,1]]\nstiffness=[[1,0],[0,1]]\n")
                .find("M must satisfy M = Mᵀ: entries (1,2) = 2 and (2,1) = 0 differ"),
            0u);
  EXPECT_EQ(broken("kind='matrices'\nlabels=['a','b']\nmass=[[1,0],[0,-1]]\nstiffness=[[1,0],[0,1]]\n"),
            "M must be positive definite: diagonal entry (2,2) = -1 of coordinate 'b' is not above 0; K is positive definite: were M and K "
            "exchanged?");
  EXPECT_NE(broken("kind='matrices'\nmass=[[1e-300,1e300],[1e300,1e-300]]\nstiffness=[[1,0],[0,1]]\n"), "(accepted)");
  EXPECT_NE(broken("kind='first_order'\ninertia=[[1,2],[2,1]]\ngyroscopic=[[0,1],[-1,0]]\n"), "(accepted)");
}

TEST_F(ModelToml, Sha256OfTheModelAndItsMatrices) {
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

TEST_F(ModelToml, Sha256IsThatOfSha256sum) {
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

}  // namespace
}  // namespace gyromode::io
