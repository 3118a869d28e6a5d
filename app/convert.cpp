#include "errors.h"
#include "input.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/models/conversion.h"
#include "gyromode/models/model_kind.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace gyromode::app {

namespace {

struct Options {
  ModelSource source;
  std::string target;
  std::optional<std::string> format;
  bool quiet = false;
  bool realified = false;
  bool transformation = false;
  std::optional<Index> elements;
};

ExitCode run(const Options& o) {
  if (o.format && !std::filesystem::path(o.target).extension().empty() && !std::filesystem::is_directory(o.target))
    throw UsageError("--to is for the files of a folder: -o DIR; one file is written by its extension");
  if (o.transformation && !o.realified) throw UsageError("--transformation goes with --realified");
  Model model = o.source.read();
  if (model.body->matrices().empty())
    model.body = model.body->discretised(o.elements);
  else if (o.elements)
    throw UsageError("--elements belongs to spacecraft models");
  const auto say = [&](const std::string& line) {
    if (!o.quiet && !line.empty()) fmt::print(stderr, "gyromode: {}\n", line);
  };
  const Conversion all = converted(model, o.realified, o.transformation);
  say(all.remark);
  const std::string written = write_matrices(all, model, o.target, o.format.value_or("mtx"));
  if (model.ignored) say(in_words(*model.ignored));
  say(written);
  return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, int& code) {
  CLI::App* verb =
      program.add_subcommand("convert", "Write the matrices of a model: Matrix Market, .npy, CSV, .mat, .npz, or a model file");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("-o,--output", o->target,
                   "Folder for M.mtx, G.mtx, K.mtx (I.mtx, G.mtx for first-order models), or one file: .mat, .npz, or .toml, a model file")
      ->type_name("DIR|FILE")
      ->required();
  verb->add_option("--to", o->format, "Of the files in a folder: mtx (Matrix Market), npy or csv")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"mtx", "npy", "csv"}));
  verb->add_option("--elements", o->elements, "Spacecraft: linear elements a cable (default 50)")
      ->type_name("N")
      ->check(CLI::Range(1, 2000));
  verb->add_flag("--realified", o->realified,
                 "Also W.mtx, the real n × n matrix whose eigenvalues are ω²: symmetric in the quadrature class, visible or hidden, and "
                 "for K ≥ 0; else upper Hessenberg");
  verb->add_flag("--transformation", o->transformation,
                 "With it U.mtx, n × 2n: u = U (q, q') obeys u'' = −Wᵀ u; where W = DᵀD also D.mtx and the orthogonal Q.mtx; where W is "
                 "not symmetric the unitary Q1.mtx + j Q2.mtx");
  verb->add_flag("--quiet", o->quiet, "No remarks on stderr; errors remain");
  verb->footer(
      "Examples:\n  gyromode convert models/three_springs.toml -o matrices\n  gyromode convert models/three_springs.toml -o springs.mat\n  "
      "gyromode convert models/wiresaw.toml -o matrices --realified "
      "--transformation");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
