#include "gyromode/formats/digest.h"
#include "gyromode/base/error.h"
#include "gyromode/base/labels.h"
#include "gyromode/base/nearest.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/formats/triplet_file.h"
#include "gyromode/read/parametrised_model.h"
#include "gyromode/read/read_model.h"
#include "gyromode/read/rotor_toml.h"
#include "gyromode/read/spacecraft_toml.h"
#include "gyromode/read/sparse_files.h"
#include "gyromode/read/structure_toml.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/read/toml_table.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/matrices.h"
#include "gyromode/models/rotor_model.h"
#include "gyromode/models/sparse_matrices_model.h"
#include "gyromode/models/spacecraft_model.h"
#include "gyromode/models/structure_model.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string_view>
#include <unordered_set>

namespace gyromode {

namespace {

using namespace io;

constexpr std::array<std::string_view, 15> matrices_keys{"parameters", "kind",      "title",  "reference",           "known",
                                                         "labels",     "frame",     "orbits", "symmetrise",          "mass",
                                                         "gyroscopic", "stiffness", "spin",   "gyroscopic_per_spin", "stiffness_per_spin2"};
constexpr std::array<std::string_view, 10> first_order_keys{"parameters", "kind",  "title",      "reference", "known",
                                                            "labels",     "frame", "symmetrise", "inertia",   "gyroscopic"};
constexpr std::array<std::string_view, 3> known_keys{"frequencies", "stability", "class"};

// What the matrices read so far agree on.
struct Agreed {
  Index n = 0;    // 0: none yet
  Labels labels;  // of the rows of those that come from files with names
};

// A square matrix that fits those before it.
std::optional<Matrix> matrix(const TomlTable& table, std::string_view key, Agreed& agreed, Digest& digest) {
  auto found = table.matrix(key, digest);
  if (!found) return std::nullopt;
  if (agreed.n != 0) extend(*found, agreed.n);
  Matrix& a = found->matrix;
  if (a.rows() != a.cols())
    table.fail(key, fmt::format("'{}' has {} rows and {} columns: a square matrix was expected", key, a.rows(), a.cols()));
  if (agreed.n != 0 && a.rows() != agreed.n) {
    table.fail(key,
               fmt::format("'{0}' is {1} × {1}: the order of the matrices before it, {2} × {2}, was expected", key, a.rows(), agreed.n));
  }
  agreed.n = a.rows();
  if (!found->labels.empty()) {
    if (!agreed.labels.empty() && found->labels != agreed.labels)
      table.fail(key, fmt::format("the rows of '{}' have other names, or another order, than those of the matrices before it; one file of "
                                  "all of them is brought to one order: gyromode convert --matrices FILE -o model.toml",
                                  key));
    agreed.labels = std::move(found->labels);
  }
  return std::move(a);
}

Matrix required(std::optional<Matrix> a, const TomlTable& table, std::string_view key) {
  if (!a) table.fail(fmt::format("key '{}' is missing: a matrix file or rows of numbers was expected", key));
  return std::move(*a);
}

// Labels that the file gives, or a file that it names, must name every coordinate once; else those that its matrix
// files have for their rows.
Labels labels_of(const TomlTable& table, Labels labels, Index n, const Labels& of_matrices) {
  if (!table.has("labels")) return static_cast<Index>(of_matrices.size()) == n ? of_matrices : Labels{};
  if (static_cast<Index>(labels.size()) != n)
    table.fail("labels", fmt::format("'labels' has {} names: {} were expected, one a coordinate", labels.size(), n));
  std::unordered_set<std::string_view> seen;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i].empty()) table.fail("labels", fmt::format("label {} is empty: a name was expected", i + 1));
    if (has_control_character(labels[i])) {
      table.fail("labels", fmt::format("label {}, '{}', has a control character: a name that prints on one line was expected", i + 1,
                                       shown(labels[i])));
    }
    if (!seen.insert(labels[i]).second)
      table.fail("labels", fmt::format("label '{}' is given twice: different names were expected", shown(labels[i])));
  }
  return labels;
}

// What is given from outside, widened by what the file asks for.
Admission admission_of(const TomlTable& table, Admission given) {
  const auto asked = table.number("symmetrise");
  if (!asked) return given;
  if (!(*asked >= 0 && *asked <= 2))
    table.fail("symmetrise", fmt::format("'symmetrise' = {}: a fraction of the largest entry, from 0 to 2, was expected", *asked));
  given.symmetrise = std::max(given.symmetrise, *asked);
  return given;
}

// Pairs of labels: displacements along x and y of one place each.
std::vector<OrbitCoordinates> orbits_of(const TomlTable& table, const Labels& given, Index n) {
  const Labels labels = given.empty() ? default_labels(n) : given;
  const std::vector<std::string_view> known(labels.begin(), labels.end());
  std::vector<OrbitCoordinates> all;
  std::unordered_set<std::string> seen;
  for (const auto& pair : table.pairs_of_words("orbits")) {
    Index at[2] = {0, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto label = std::find(labels.begin(), labels.end(), pair[k]);
      if (label == labels.end())
        table.fail("orbits", fmt::format("'orbits': '{}' is no label of the model{}", shown(pair[k]), suggestion(pair[k], known)));
      if (!seen.insert(pair[k]).second) table.fail("orbits", fmt::format("'orbits': '{}' is given twice", shown(pair[k])));
      at[k] = label - labels.begin();
    }
    all.push_back({at[0], at[1], fmt::format("{}, {}", pair[0], pair[1])});
  }
  return all;
}

// Matrices in Matrix Market files of coordinates that dense methods do not serve; null of others.
std::shared_ptr<const ModelKind> read_large(const TomlTable& table, Digest& digest) {
  const auto file = [&](std::string_view key) { return table.is_text(key) ? table.folder() / *table.text(key) : std::filesystem::path(); };
  const auto order = order_of_large(file("mass"));
  if (!order) return nullptr;
  for (const std::string_view key : {"gyroscopic_per_spin", "stiffness_per_spin2", "spin", "orbits", "symmetrise"}) {
    if (table.has(key)) table.fail(key, fmt::format("'{}' is for dense matrices: models of {} coordinates have M, G and K", key, *order));
  }
  for (const std::string_view key : {"gyroscopic", "stiffness"}) {
    if (table.has(key) && !table.is_text(key))
      table.fail(key, fmt::format("'{}' must be a file, as 'mass' is one of order {}", key, *order));
  }
  SparseMatrices m = read_sparse_files({file("mass"), file("gyroscopic"), file("stiffness")}, *order, digest);
  m.labels = table.texts_or_file("labels");
  return model_of_sparse(std::move(m));
}

std::shared_ptr<const ModelKind> read_second_order(const TomlTable& table, const Admission& given, std::optional<double>& spin,
                                                   Digest& digest) {
  table.allow_only(matrices_keys);
  if (auto large = read_large(table, digest)) return large;
  Labels given_labels = table.texts_or_file("labels");
  Agreed agreed;
  Matrix mass = required(matrix(table, "mass", agreed, digest), table, "mass");
  std::optional<Matrix> gyroscopic = matrix(table, "gyroscopic", agreed, digest);
  std::optional<Matrix> stiffness = matrix(table, "stiffness", agreed, digest);
  const std::optional<Matrix> per_spin = matrix(table, "gyroscopic_per_spin", agreed, digest);
  const std::optional<Matrix> per_spin2 = matrix(table, "stiffness_per_spin2", agreed, digest);
  spin = table.frequency("spin");
  if (spin && !per_spin && !per_spin2) {
    table.fail("spin", "'spin' has nothing to act on: 'gyroscopic_per_spin' or 'stiffness_per_spin2' was expected beside it");
  }
  if (!spin && per_spin) table.fail("gyroscopic_per_spin", "'gyroscopic_per_spin' needs 'spin' = a frequency");
  if (!spin && per_spin2) table.fail("stiffness_per_spin2", "'stiffness_per_spin2' needs 'spin' = a frequency");
  const Index n = agreed.n;
  Labels labels = labels_of(table, std::move(given_labels), n, agreed.labels);
  Matrix g = gyroscopic ? std::move(*gyroscopic) : Matrix::Zero(n, n);
  Matrix k = stiffness ? std::move(*stiffness) : Matrix::Zero(n, n);
  const Admission admission = admission_of(table, given);
  std::vector<OrbitCoordinates> orbits = orbits_of(table, labels, n);
  return model_of({std::make_shared<const SpinFamily>(SpinFamily{std::move(mass), std::move(g), per_spin.value_or(Matrix()), std::move(k),
                                                                 per_spin2.value_or(Matrix()), std::move(labels), admission}),
                   spin, std::move(orbits)});
}

std::shared_ptr<const ModelKind> read_first_order(const TomlTable& table, const Admission& given, std::optional<double>&, Digest& digest) {
  table.allow_only(first_order_keys);
  Labels given_labels = table.texts_or_file("labels");
  Agreed agreed;
  Matrix inertia = required(matrix(table, "inertia", agreed, digest), table, "inertia");
  Matrix g = required(matrix(table, "gyroscopic", agreed, digest), table, "gyroscopic");
  Labels labels = labels_of(table, std::move(given_labels), agreed.n, agreed.labels);
  return std::make_shared<FirstOrderModel>(
      FirstOrderSystem(std::move(inertia), std::move(g), std::move(labels), admission_of(table, given)));
}

std::shared_ptr<const ModelKind> read_spacecraft_model(const TomlTable& table, const Admission&, std::optional<double>& spin, Digest&) {
  Spacecraft s = read_spacecraft(table);
  spin = s.spin();
  return std::make_shared<SpacecraftModel>(std::move(s));
}

std::shared_ptr<const ModelKind> read_rotor_model(const TomlTable& table, const Admission&, std::optional<double>& spin, Digest&) {
  Rotor r = read_rotor(table);
  spin = r.parts().speed;
  return std::make_shared<RotorModel>(std::move(r));
}

std::shared_ptr<const ModelKind> read_structure_model(const TomlTable& table, const Admission&, std::optional<double>& spin,
                                                      Digest& digest) {
  if (table.has("gyroscopic")) return model_of_sparse(read_sparse_matrices(table, digest));
  StructureParts p = read_structure(table, digest);
  spin = p.spin;
  return model_of_structure(std::move(p));
}

// Every kind: its word in model files, and who reads it.
struct Kind {
  std::string_view word;
  std::shared_ptr<const ModelKind> (*read)(const TomlTable& table, const Admission& given, std::optional<double>& spin, Digest& digest);
  Frame frame;  // where the file says nothing
};
constexpr Kind kinds[] = {
    {"matrices", read_second_order, Frame::unknown},       {"first_order", read_first_order, Frame::unknown},
    {"spacecraft", read_spacecraft_model, Frame::turning}, {"rotor", read_rotor_model, Frame::fixed},
    {"structure", read_structure_model, Frame::turning},
};

std::string quoted_kinds(char quote) {
  std::string words;
  for (std::size_t k = 0; k < std::size(kinds); ++k)
    words += fmt::format("{}{}{}{}", k == 0 ? "" : k + 1 == std::size(kinds) ? " or " : ", ", quote, kinds[k].word, quote);
  return words;
}

std::string one_of(const TomlTable& table, std::string_view key, std::initializer_list<std::string_view> words) {
  std::string word = table.text(key).value_or("");
  if (!word.empty() && std::find(words.begin(), words.end(), word) == words.end()) {
    table.fail(key, fmt::format("'{}' is no {}: {} was expected", shown(word), key, fmt::join(words, ", ")));
  }
  return word;
}

KnownValues read_known(const TomlTable& table) {
  KnownValues known;
  const auto inner = table.table("known");
  if (!inner) return known;
  inner->allow_only(known_keys);
  known.frequencies = inner->numbers("frequencies");
  known.stability = one_of(*inner, "stability", {"stable", "gyroscopically_stabilised", "marginal", "unstable"});
  known.system_class = one_of(*inner, "class", {"quadrature", "hidden_quadrature", "general", "transcendental"});
  if (!std::is_sorted(known.frequencies.begin(), known.frequencies.end()))
    inner->fail("frequencies", "'frequencies' do not ascend: rad/s in ascending order were expected");
  return known;
}

}  // namespace

Model read_model(const std::filesystem::path& file, const Admission& admission) {
  if (const std::string_view what = matrix_format(start_of(file)); !what.empty())
    throw Unreadable(
        file, fmt::format("is a matrix file ({}), no model: --mass, --gyroscopic, --stiffness or --matrices was expected before it", what));
  const std::string text = read_text(file, "TOML model");
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::string_view begins = first == std::string::npos ? std::string_view() : std::string_view(text).substr(first, 1);
  if (!begins.empty() && std::string_view("0123456789+-.").find(begins) != std::string_view::npos)
    throw Unreadable(file, "is a table of numbers, no model: --mass, --gyroscopic or --stiffness was expected before it");
  return parse_model(text, file, admission);
}

Model parse_model(std::string_view text, const std::filesystem::path& name, const Admission& admission) {
  const TomlTable table(text, name);
  const std::string word = table.text("kind").value_or("");
  if (word.empty()) table.fail(fmt::format("key 'kind' is missing: kind = {} was expected", quoted_kinds('"')));
  const auto kind = std::find_if(std::begin(kinds), std::end(kinds), [&](const Kind& k) { return k.word == word; });
  if (kind == std::end(kinds))
    table.fail("kind", fmt::format("kind '{}' is not known to this version: {} was expected", shown(word), quoted_kinds('\'')));
  Digest digest;
  digest.add(text);
  std::optional<double> spin;
  std::shared_ptr<const ModelKind> body = kind->read(table, admission, spin, digest);
  if (!table.parameters().empty()) {
    const auto make = [table, admission, read = kind->read](const std::vector<ParameterValue>& values) -> ParametrisedModel::Made {
      const TomlTable changed = table.with_parameters(values);
      Digest unused;
      std::optional<double> unused_spin;
      return {changed.parameters(), read(changed, admission, unused_spin, unused)};
    };
    body = std::make_shared<ParametrisedModel>(make, ParametrisedModel::Made{table.parameters(), body});
  }
  Model model(std::move(body), word);
  model.title = table.text("title").value_or(name.stem().string());
  model.reference = table.text("reference").value_or("");
  model.sha256 = digest.sha256();
  model.files = digest.files();
  model.files.push_back(name);
  model.spin = spin;
  const std::string frame = one_of(table, "frame", {"turning", "fixed"});
  const bool own_g = word == "structure" && table.has("gyroscopic");  // in axes that it does not say
  model.frame = frame == "turning" ? Frame::turning : frame == "fixed" ? Frame::fixed : own_g ? Frame::unknown : kind->frame;
  model.known = read_known(table);
  return model;
}

}  // namespace gyromode
