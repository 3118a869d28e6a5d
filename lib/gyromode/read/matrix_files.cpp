#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/formats/digest.h"
#include "gyromode/formats/matrix_file.h"
#include "gyromode/formats/text_file.h"
#include "gyromode/models/family_parameters.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/read/labels_file.h"
#include "gyromode/read/read_model.h"
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
  digest.add(bytes);
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

// The one with the name asked for; else the only one with a name that people give it.
template <std::size_t N>
const NamedMatrix* found(const std::vector<NamedMatrix>& all, const std::string& asked, const std::array<std::string_view, N>& names,
                         std::string_view what, const std::filesystem::path& file) {
  const NamedMatrix* one = nullptr;
  for (const NamedMatrix& m : all) {
    if (asked.empty() ? !called(m.name, names) : m.name != asked) continue;
    if (one)
      throw Unreadable(
          file, fmt::format("'{}' and '{}' may both be {}: --names {}=NAME was expected", shown(one->name), shown(m.name), what, what));
    one = &m;
  }
  if (!one && !asked.empty())
    throw Unreadable(file, fmt::format("holds no matrix '{}' for {}: it has {}", shown(asked), what, listed(all)));
  return one;
}

// G and K that name their rows, and M likewise, in the order of all names; zero where a matrix does not name a row.
void bring_to_one_order(const std::vector<Sourced*>& matrices) {
  Labels all;
  std::set<std::string_view> seen;
  for (const Sourced* s : matrices) {
    if (s->matrix.labels.empty()) return;
    for (const std::string& label : s->matrix.labels) {
      if (seen.insert(label).second) all.push_back(label);
    }
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

// A column or row of n numbers is a diagonal.
void to_square(Sourced& s) {
  Matrix& a = s.matrix.matrix;
  if (a.rows() == a.cols()) return;
  if (std::min(a.rows(), a.cols()) == 1) {
    a = Matrix(Vector(a.reshaped()).asDiagonal());
    return;
  }
  throw Unreadable(s.file,
                   fmt::format("'{}' has {} rows and {} columns: a square matrix was expected", shown(s.matrix.name), a.rows(), a.cols()));
}

}  // namespace

Model read_matrices(const MatrixFiles& files, const Admission& admission) {
  Digest digest;
  std::optional<Sourced> m, g, k;
  if (files.container.empty()) {
    m = read_one(files.mass, digest);
    if (!files.gyroscopic.empty()) g = read_one(files.gyroscopic, digest);
    if (!files.stiffness.empty()) k = read_one(files.stiffness, digest);
  } else {
    const std::string bytes = read_bytes(files.container, "matrix");
    digest.add(bytes);
    const std::vector<NamedMatrix> all = parse_matrices(bytes, files.container, most_coordinates);
    const auto take = [&](const NamedMatrix* one) {
      if (one) require_fit(*one, files.container);
      return one ? std::optional(Sourced{*one, files.container}) : std::nullopt;
    };
    m = take(found(all, files.mass_name, mass_names, "M", files.container));
    g = take(found(all, files.gyroscopic_name, gyroscopic_names, "G", files.container));
    k = take(found(all, files.stiffness_name, stiffness_names, "K", files.container));
    if (!m)
      throw Unreadable(
          files.container,
          fmt::format("holds no mass matrix that is known by its name: it has {}; --names M=NAME,G=NAME,K=NAME was expected", listed(all)));
    for (const NamedMatrix& one : all) {
      if (called(one.name, damping_names) && one.name != files.gyroscopic_name && one.matrix.size() > 0 &&
          one.matrix.cwiseAbs().maxCoeff() > 0)
        throw LawBroken(
            files.container, 0, 0,
            fmt::format("holds a damping matrix '{}' that is not 0: damping is not served; leave it out for the undamped modes, or name it "
                        "where it is gyroscopic: --names G={}",
                        shown(one.name), shown(one.name)));
    }
  }
  std::vector<Sourced*> matrices{&*m};
  if (g) matrices.push_back(&*g);
  if (k) matrices.push_back(&*k);
  for (Sourced* s : matrices) to_square(*s);
  bring_to_one_order(matrices);
  const Index n = m->matrix.matrix.rows();
  for (const Sourced* s : matrices) {
    if (s->matrix.matrix.rows() == n) continue;
    throw Unreadable(
        s->file, fmt::format("is {0} × {0}: the order of '{2}', {1} × {1}, was expected", s->matrix.matrix.rows(), n, m->file.string()));
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
  return model;
}

}  // namespace gyromode
