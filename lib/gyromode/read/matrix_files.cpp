#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/formats/digest.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/formats/triplet_file.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/sparse_matrices_model.h"
#include "gyromode/read/labels_file.h"
#include "gyromode/read/read_model.h"
#include "gyromode/read/sparse_files.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <string_view>

namespace gyromode {

namespace {

using namespace io;

// A matrix with the file that it is from.
struct Sourced {
  NamedMatrix matrix;
  std::filesystem::path file;
};

Sourced read_one(const std::filesystem::path& written, Digest& digest) {
  const MatrixPlace place = matrix_place(written);
  const std::string bytes = read_bytes(place.file, "matrix");
  digest.add(place.file, bytes);
  return {chosen_matrix(parse_matrices(bytes, place.file, most_coordinates), place), place.file};
}

std::string lower(std::string_view text) {
  std::string out;
  for (const char c : text) out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

// What programs and people call the three, in small letters.
constexpr std::array<std::string_view, 7> mass_names{"m", "mass", "mmat", "maa", "maax", "mgg", "mass_matrix"};
constexpr std::array<std::string_view, 8> gyroscopic_names{"g",    "gyro",     "gyroscopic", "gyr",
                                                           "gmat", "coriolis", "bgaa",       "gyroscopic_matrix"};
constexpr std::array<std::string_view, 8> stiffness_names{"k", "stiff", "stiffness", "kmat", "kaa", "kaax", "kgg", "stiffness_matrix"};
constexpr std::array<std::string_view, 6> damping_names{"c", "d", "damp", "damping", "baa", "bgg"};

template <std::size_t N>
bool called(const std::string& name, const std::array<std::string_view, N>& names) {
  return std::find(names.begin(), names.end(), lower(name)) != names.end();
}

std::string listed(const std::vector<NamedMatrix>& all) {
  std::string names;
  for (const NamedMatrix& m : all) names += (names.empty() ? "" : ", ") + shown(m.name);
  return names;
}

// The one with the name asked for; else the one with a name that people give it, of those that are square of order n or
// a diagonal of it (0: of the largest order that there is).
template <std::size_t N>
const NamedMatrix* found(const std::vector<NamedMatrix>& all, const std::string& asked, const std::array<std::string_view, N>& names,
                         std::string_view what, Index n, const std::filesystem::path& file) {
  const auto order = [](const NamedMatrix& m) { return std::max(m.matrix.rows(), m.matrix.cols()); };
  const NamedMatrix* one = nullptr;
  for (const NamedMatrix& m : all) {
    if (asked.empty() ? !called(m.name, names) : m.name != asked) continue;
    if (asked.empty() && n > 0 && m.unfit.empty() && order(m) != n && m.labels.empty() && !m.may_go_on) continue;
    if (one && n == 0 && order(*one) != order(m)) {
      if (order(m) > order(*one)) one = &m;
      continue;
    }
    if (one)
      throw Unreadable(
          file, fmt::format("'{}' and '{}' may both be {}: --names {}=NAME was expected", shown(one->name), shown(m.name), what, what));
    one = &m;
  }
  if (!one && !asked.empty())
    throw Unreadable(file, fmt::format("holds no matrix '{}' for {}: it has {}", shown(asked), what, listed(all)));
  return one;
}

// M, G and K that name their rows in the order of all names; zero where a matrix does not name a row.
void bring_to_one_order(const std::vector<Sourced*>& matrices) {
  Labels all;
  std::set<std::string_view> seen;
  bool alike = true, some_without = false;
  for (const Sourced* s : matrices) {
    const Labels& own = s->matrix.labels;
    if (own.empty()) {
      some_without = true;
      continue;
    }
    std::set<std::string_view> once;
    for (const std::string& label : own) {
      if (!once.insert(label).second)
        throw Unreadable(
            s->file, fmt::format("'{}' names two of its rows '{}': different names were expected", shown(s->matrix.name), shown(label)));
      if (seen.insert(label).second) all.push_back(label);
    }
    alike = alike && (own == all);
  }
  if (all.empty()) return;
  if (some_without) {
    if (alike) return;
    throw Unreadable(
        matrices.front()->file,
        "and the other matrices name their rows in different orders, and one has no names: names for all, or for none, were expected");
  }
  const auto dof = [](const std::string& label) {  // grid point and component
    const std::size_t dot = label.find('.');
    return std::pair(std::atoll(label.c_str()), dot == std::string::npos ? 0LL : std::atoll(label.c_str() + dot + 1));
  };
  std::stable_sort(all.begin(), all.end(), [&](const std::string& a, const std::string& b) { return dof(a) < dof(b); });
  std::map<std::string, Index> place;
  for (const std::string& label : all) place.emplace(label, static_cast<Index>(place.size()));
  for (Sourced* s : matrices) {
    if (s->matrix.labels == all) continue;
    Matrix whole = Matrix::Zero(static_cast<Index>(all.size()), static_cast<Index>(all.size()));
    std::vector<Index> at;
    for (const std::string& label : s->matrix.labels) at.push_back(place.at(label));
    whole(at, at) = s->matrix.matrix;
    s->matrix.matrix = std::move(whole);
    s->matrix.labels = all;
  }
}

// Square matrices of the order of M that nobody took: K or G by a name that is not known, perhaps.
std::string left_over(const std::vector<NamedMatrix>& all, const std::vector<const NamedMatrix*>& taken) {
  std::string names;
  const Index n = taken.front()->matrix.rows();
  for (const NamedMatrix& m : all) {
    if (!m.unfit.empty() || m.matrix.rows() != n || m.matrix.cols() != n || std::find(taken.begin(), taken.end(), &m) != taken.end())
      continue;
    names += (names.empty() ? "'" : ", '") + shown(m.name) + "'";
  }
  return names;
}

// The three of a container. Where a name is not known nothing is taken for 0 that may be there by another one.
struct Three {
  std::optional<Sourced> m, g, k;
};
Three from_container(const std::vector<NamedMatrix>& all, const MatrixFiles& files) {
  const std::filesystem::path& file = files.container;
  const bool named = !files.mass_name.empty() || !files.gyroscopic_name.empty() || !files.stiffness_name.empty();
  const NamedMatrix* m = found(all, files.mass_name, mass_names, "M", 0, file);
  if (!m)
    throw Unreadable(
        file,
        fmt::format("holds no mass matrix that is known by its name: it has {}; --names M=NAME,G=NAME,K=NAME was expected", listed(all)));
  require_fit(*m, file);
  const Index n = std::max(m->matrix.rows(), m->matrix.cols());
  const Index order = m->labels.empty() && !m->may_go_on ? n : -1;  // −1: that of others may differ
  const NamedMatrix* g = found(all, files.gyroscopic_name, gyroscopic_names, "G", order, file);
  const NamedMatrix* k = found(all, files.stiffness_name, stiffness_names, "K", order, file);
  if (!k && !named)
    throw Unreadable(file, fmt::format("holds no stiffness matrix that is known by its name: it has {}; --names M=NAME,K=NAME was expected",
                                       listed(all)));
  std::vector<const NamedMatrix*> taken{m};
  for (const NamedMatrix* one : {g, k}) {
    if (one) require_fit(*one, file);
    if (one) taken.push_back(one);
  }
  for (const NamedMatrix& one : all) {
    if (named || !called(one.name, damping_names) || std::max(one.matrix.rows(), one.matrix.cols()) != n) continue;
    if (one.matrix.cwiseAbs().maxCoeff() > 0)
      throw LawBroken(file, 0, 0,
                      fmt::format("holds a damping matrix '{}' that is not 0: damping is not served; leave it out for the undamped modes "
                                  "(--names M={},K={}), or "
                                  "name it where it is gyroscopic: --names G={}",
                                  shown(one.name), shown(m->name), k ? shown(k->name) : "NAME", shown(one.name)));
  }
  if (const std::string names = left_over(all, taken); !g && !named && !names.empty())
    throw Unreadable(
        file,
        fmt::format(
            "holds {}, and no matrix that is known as G by its name: --names M={},G=NAME,K={}, or without G= where it is 0, was expected",
            names, shown(m->name), shown(k->name)));
  const auto sourced = [&](const NamedMatrix* one) { return one ? std::optional(Sourced{*one, file}) : std::nullopt; };
  return {sourced(m), sourced(g), sourced(k)};
}

Model read_large(const MatrixFiles& files, Index order) {
  Digest digest;
  SparseMatrices m = read_sparse_files({files.mass, files.gyroscopic, files.stiffness}, order, digest);
  if (!files.labels.empty()) m.labels = io::read_labels(files.labels);
  Model model(model_of_sparse(std::move(m)), "matrices");
  model.title = files.mass.stem().string();
  model.sha256 = digest.sha256();
  model.files = digest.files();
  if (!files.labels.empty()) model.files.push_back(files.labels);
  return model;
}

}  // namespace

Model read_matrices(const MatrixFiles& files, const Admission& admission) {
  if (const auto order = files.container.empty() ? io::order_of_large(files.mass) : std::nullopt) return read_large(files, *order);
  Digest digest;
  Three all;
  if (files.container.empty()) {
    all.m = read_one(files.mass, digest);
    if (!files.gyroscopic.empty()) all.g = read_one(files.gyroscopic, digest);
    if (!files.stiffness.empty()) all.k = read_one(files.stiffness, digest);
  } else {
    const std::string bytes = read_bytes(files.container, "matrix");
    digest.add(files.container, bytes);
    all = from_container(parse_matrices(bytes, files.container, most_coordinates), files);
  }
  auto& [m, g, k] = all;
  std::vector<Sourced*> matrices{&*m};
  if (g) matrices.push_back(&*g);
  if (k) matrices.push_back(&*k);
  for (Sourced* s : matrices) make_square(s->matrix, s->file);
  bring_to_one_order(matrices);
  Index largest = 0;
  for (const Sourced* s : matrices) largest = std::max(largest, s->matrix.matrix.rows());
  for (Sourced* s : matrices) extend(s->matrix, largest);
  const Index n = m->matrix.matrix.rows();
  for (const Sourced* s : matrices) {
    if (s->matrix.matrix.rows() == n) continue;
    throw Unreadable(s->file, fmt::format("'{3}' is {0} × {0}: the order of '{4}' in '{2}', {1} × {1}, was expected",
                                          s->matrix.matrix.rows(), n, m->file.string(), shown(s->matrix.name), shown(m->matrix.name)));
  }
  if (!files.labels.empty()) {
    m->matrix.labels = io::read_labels(files.labels);
    if (static_cast<Index>(m->matrix.labels.size()) != n)
      throw Unreadable(files.labels, fmt::format("has {} labels: {} were expected, one a coordinate", m->matrix.labels.size(), n));
  }
  SpinFamily family{std::move(m->matrix.matrix),
                    g ? std::move(g->matrix.matrix) : Matrix::Zero(n, n),
                    {},
                    k ? std::move(k->matrix.matrix) : Matrix::Zero(n, n),
                    {},
                    std::move(m->matrix.labels),
                    admission};
  Model model(model_of({std::make_shared<const SpinFamily>(std::move(family)), std::nullopt}), "matrices");
  model.title = m->file.stem().string();
  model.sha256 = digest.sha256();
  model.files = digest.files();
  if (!files.labels.empty()) model.files.push_back(files.labels);
  return model;
}

}  // namespace gyromode
