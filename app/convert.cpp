#include "errors.h"
#include "exit_code.h"
#include "input.h"
#include "verbs.h"

#include "gyromode/discrete/discretise.h"
#include "gyromode/io/matrix_market.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace gyromode::app {

namespace {

namespace fs = std::filesystem;

struct Options {
  ModelSource source;
  std::string folder;
  bool quiet = false;
  std::optional<Index> elements;
};

void write_system(const fs::path& folder, const System& s, const std::string& title) {
  io::write_matrix_market(folder / "M.mtx", s.mass(), io::Symmetry::symmetric, title + ": mass M");
  io::write_matrix_market(folder / "G.mtx", s.gyroscopic(), io::Symmetry::skew_symmetric, title + ": gyroscopic G");
  io::write_matrix_market(folder / "K.mtx", s.stiffness(), io::Symmetry::symmetric, title + ": stiffness K");
}

void write_system(const fs::path& folder, const FirstOrderSystem& s, const std::string& title) {
  io::write_matrix_market(folder / "I.mtx", s.inertia(), io::Symmetry::symmetric, title + ": inertia I of I q' + G q = 0");
  io::write_matrix_market(folder / "G.mtx", s.gyroscopic(), io::Symmetry::skew_symmetric, title + ": gyroscopic G of I q' + G q = 0");
}

int run(const Options& o) {
  io::Model model = o.source.read();
  if (const auto* craft = std::get_if<Spacecraft>(&model.system)) model.system = System(discretise(*craft, Mesh{o.elements.value_or(Mesh{}.elements), 1}));
  else if (o.elements) throw UsageError("--elements belongs to spacecraft models");
  std::error_code error;
  fs::create_directories(o.folder, error);
  if (!fs::is_directory(o.folder)) throw io::InputError(o.folder, "cannot be made a folder: a place to write matrices was expected");
  std::visit([&](const auto& system) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(system)>, Spacecraft>) write_system(o.folder, system, model.title);
  }, model.system);
  if (!o.quiet) fmt::print(stderr, "gyromode: {} written to {}\n", std::holds_alternative<System>(model.system) ? "M.mtx, G.mtx, K.mtx" : "I.mtx, G.mtx", o.folder);
  return done;
}

}  // namespace

void add_convert(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("convert", "Write the matrices of a model as Matrix Market files");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb, false);
  verb->add_option("-o,--output", o->folder, "Folder for M.mtx, G.mtx, K.mtx (I.mtx, G.mtx for first-order models)")->type_name("DIR")->required();
  verb->add_option("--elements", o->elements, "Spacecraft: linear elements a cable (default 50)")->type_name("N")->check(CLI::Range(1, 2000));
  verb->add_flag("--quiet", o->quiet, "No remarks on stderr; errors remain");
  verb->footer("Example:\n  gyromode convert models/three_springs.toml -o matrices");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
