// Models of matrices: keys, laws of spin, defaults, and what is refused where.
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

using ModelToml = ModelFolder;

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
  const std::string expected =
      "model.toml:1: key 'kind' is missing: kind = \"matrices\", \"first_order\", \"spacecraft\", \"rotor\" or \"structure\" was expected";
  EXPECT_EQ(error("title = 't'\n"), expected);
  EXPECT_EQ(error("# nothing\n"), expected);
  EXPECT_EQ(error("kind = ''\n"), expected);
  EXPECT_EQ(error("\nkind = 'turbine'\n"),
            "model.toml:2:8: kind 'turbine' is not known to this version: 'matrices', 'first_order', 'spacecraft', 'rotor' or 'structure' "
            "was expected");
  EXPECT_EQ(error("kind = 'Matrices'\n"),
            "model.toml:1:8: kind 'Matrices' is not known to this version: 'matrices', 'first_order', 'spacecraft', 'rotor' or 'structure' "
            "was expected");
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
    EXPECT_EQ(error("kind='matrices'\nlabels=" + value),
              "model.toml:2:8: 'labels' is " + word + ": an array of strings, or a file of them, was expected");
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

}  // namespace
}  // namespace gyromode::io
