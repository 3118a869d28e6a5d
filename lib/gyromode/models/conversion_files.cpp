#include "gyromode/base/error.h"
#include "gyromode/formats/matlab.h"
#include "gyromode/formats/number_table.h"
#include "gyromode/formats/numpy.h"
#include "gyromode/formats/write_file.h"
#include "gyromode/models/conversion.h"
#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

#include <system_error>

namespace gyromode {

namespace {

namespace fs = std::filesystem;

std::vector<NamedMatrix> named(const Conversion& c) {
  std::vector<NamedMatrix> all;
  for (const ConvertedMatrix& a : c.matrices) all.push_back({a.name, a.matrix, {}});
  return all;
}

std::string quoted(const std::string& text) {  // a basic string of TOML
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      out += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
    else
      out += c;
  }
  return out + "\"";
}

void require_no_input(const fs::path& target, const Model& model) {
  for (const fs::path& file : model.files) {
    std::error_code error;
    if (fs::equivalent(target, file, error) && !error)
      throw InvalidArgument(
          fmt::format("{} is a file that the model was read from, and would be overwritten: another place was expected", target.string()));
  }
}

std::string rows(const Matrix& a) {
  std::string text = "[";
  for (Index i = 0; i < a.rows(); ++i) {
    text += i == 0 ? "[" : ",\n  [";
    for (Index j = 0; j < a.cols(); ++j) text += fmt::format("{}{}", j == 0 ? "" : ", ", a(i, j) == 0 ? 0.0 : a(i, j));
    text += "]";
  }
  return text + "]";
}

// The parts that go with the spin by themselves, so that the file serves every spin.
std::string family_rows(const SpinFamily& f, double spin) {
  std::string text = fmt::format("spin = {}\n", spin);
  const std::pair<const char*, const Matrix*> parts[] = {{"mass", &f.mass},
                                                         {"gyroscopic", &f.gyroscopic},
                                                         {"gyroscopic_per_spin", &f.gyroscopic_per_spin},
                                                         {"stiffness", &f.stiffness},
                                                         {"stiffness_per_spin2", &f.stiffness_per_spin2}};
  for (const auto& [key, a] : parts) {
    if (a->size() > 0 && (key != parts[1].first || a->cwiseAbs().maxCoeff() > 0)) text += fmt::format("{} = {}\n", key, rows(*a));
  }
  return text;
}

std::string model_file(const Conversion& c, const Model& model) {
  const bool first_order = !c.matrices.empty() && c.matrices.front().name == "I";
  std::string text = fmt::format("kind = \"{}\"\ntitle = {}\n", first_order ? "first_order" : "matrices", quoted(model.title));
  if (model.frame != Frame::unknown) text += fmt::format("frame = \"{}\"\n", to_string(model.frame));
  if (!c.labels.empty()) {
    text += "labels = [";
    for (std::size_t i = 0; i < c.labels.size(); ++i) text += (i == 0 ? "" : ", ") + quoted(c.labels[i]);
    text += "]\n";
  }
  if (!model.body->orbits().empty() && static_cast<Index>(c.labels.size()) == model.size()) {
    text += "orbits = [";
    bool first = true;
    for (const OrbitCoordinates& p : model.body->orbits()) {
      text += fmt::format("{}[{}, {}]", first ? "" : ", ", quoted(c.labels[static_cast<std::size_t>(p.x)]),
                          quoted(c.labels[static_cast<std::size_t>(p.y)]));
      first = false;
    }
    text += "]\n";
  }
  if (c.family) return text + family_rows(*c.family, *model.spin);
  for (const ConvertedMatrix& a : c.matrices) {
    const char* key = a.name == "M"   ? "mass"
                      : a.name == "G" ? "gyroscopic"
                      : a.name == "K" ? "stiffness"
                      : a.name == "I" ? "inertia"
                                      : nullptr;
    if (!key) throw InvalidArgument(fmt::format("a model file has no place for {}: write a folder, .mat or .npz", a.name));
    text += fmt::format("{} = {}\n", key, rows(a.matrix));
  }
  return text;
}

std::string into_folder(const Conversion& c, const Model& model, const fs::path& folder, const std::string& format) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) throw Unreadable(folder, "cannot be made a folder: a place to write matrices was expected");
  std::string names;
  for (const ConvertedMatrix& a : c.matrices) require_no_input(folder / (a.name + "." + format), model);
  for (const ConvertedMatrix& a : c.matrices) {
    const fs::path file = folder / (a.name + "." + format);
    if (format == "npy")
      io::write_file(file, io::format_npy(a.matrix));
    else if (format == "csv")
      io::write_file(file, io::format_number_table(a.matrix));
    else
      write_matrix_market(file, a.matrix, a.symmetry, model.title + ": " + a.meaning);
    names += fmt::format("{}{}.{}", names.empty() ? "" : ", ", a.name, format);
  }
  return fmt::format("{} written to {}", names, folder.string());
}

}  // namespace

std::string write_matrices(const Conversion& c, const Model& model, const fs::path& target, const std::string& format) {
  if (format != "mtx" && format != "npy" && format != "csv")
    throw InvalidArgument(fmt::format("matrices are not written as '{}': mtx, npy or csv was expected", format));
  const std::string extension = target.extension().string();
  if (extension.empty() || fs::is_directory(target)) return into_folder(c, model, target, format);
  require_no_input(target, model);
  if (extension == ".mat") {
    io::write_matlab(target, named(c));
  } else if (extension == ".npz") {
    io::write_file(target, io::format_npz(named(c)));
  } else if (extension == ".toml") {
    io::write_file(target, model_file(c, model));
  } else {
    throw InvalidArgument(fmt::format("'{}': a folder, or a file that ends in .mat, .npz or .toml was expected", target.string()));
  }
  std::string names;
  for (const ConvertedMatrix& a : c.matrices) names += (names.empty() ? "" : ", ") + a.name;
  return fmt::format("{} written to {}", names, target.string());
}

}  // namespace gyromode
