#include "errors.h"
#include "input.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/dense/constant_form.h"
#include "gyromode/dense/unitary_form.h"
#include "gyromode/formats/matrix_market.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/structure/structure.h"

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
  bool realified = false;
  bool transformation = false;
  std::optional<Index> elements;
};

// "M.mtx, G.mtx, K.mtx", and the files of these names.
std::string write_matrices(const fs::path& folder, const Model& model) {
  std::string names;
  for (const ModelKind::NamedMatrix& a : model.body->matrices()) {
    write_matrix_market(folder / (a.name + ".mtx"), *a.matrix, a.skew ? Symmetry::skew_symmetric : Symmetry::symmetric,
                        model.title + ": " + a.meaning);
    names += fmt::format("{}{}.mtx", names.empty() ? "" : ", ", a.name);
  }
  return names;
}

// W.mtx, and with it U.mtx = [displacement velocity]; D.mtx and Q.mtx where W = DᵀD.
std::string write_constant_form(const fs::path& folder, const System& s, const dense::ConstantForm& form, const Options& o,
                                const std::string& title) {
  write_matrix_market(folder / "W.mtx", form.w, Symmetry::symmetric, title + ": eigenvalues ω². " + form.solver);
  std::string names = ", W.mtx";
  if (!o.transformation) return names;
  Matrix u(s.size(), 2 * s.size());
  u << form.displacement, form.velocity;
  write_matrix_market(folder / "U.mtx", u, Symmetry::general, title + ": u = U (q, q') obeys u'' = -W u");
  names += ", U.mtx";
  if (form.bidiagonal) {
    write_matrix_market(folder / "D.mtx", *form.bidiagonal, Symmetry::general, title + ": bidiagonal D, W = D'D");
    write_matrix_market(folder / "Q.mtx", *form.orthogonal, Symmetry::general, title + ": orthogonal Q of order 2n, Z = Q T Q'");
    names += ", D.mtx, Q.mtx";
  }
  return names;
}

// W.mtx, Q1.mtx and Q2.mtx of the unitary form, which every system has; and U.mtx with the transformation.
std::string write_unitary_form(const fs::path& folder, const System& s, const Options& o, const std::string& title) {
  const dense::UnitaryForm form = dense::unitary_form(s);
  write_matrix_market(folder / "W.mtx", form.w, Symmetry::general,
                      title + ": eigenvalues ω². Upper Hessenberg, from the Hamiltonian form by the unitary matrix Q1 + jQ2 (T8e)");
  if (!o.transformation) return ", W.mtx";
  Matrix u(s.size(), 2 * s.size());
  u << form.displacement, form.velocity;
  write_matrix_market(folder / "U.mtx", u, Symmetry::general, title + ": v = U (q, q') obeys v'' = -W' v");
  write_matrix_market(folder / "Q1.mtx", form.q1, Symmetry::general, title + ": real part of the unitary Q1 + jQ2");
  write_matrix_market(folder / "Q2.mtx", form.q2, Symmetry::general, title + ": imaginary part of the unitary Q1 + jQ2");
  return ", W.mtx, U.mtx, Q1.mtx, Q2.mtx";
}

ExitCode run(const Options& o) {
  if (o.transformation && !o.realified) throw UsageError("--transformation goes with --realified");
  Model model = o.source.read();
  if (model.body->matrices().empty())
    model.body = model.body->discretised(o.elements);
  else if (o.elements)
    throw UsageError("--elements belongs to spacecraft models");
  const System* second_order = model.body->second_order();
  std::optional<dense::ConstantForm> form;  // symmetric, where there is one
  if (o.realified) {
    if (!second_order) throw NotApplicable("--realified is for models of second order: eigenvalues of W are their ω²");
    try {
      form = dense::constant_form(*second_order, analyse(*second_order, HiddenSearch::always));
    } catch (const NotApplicable& why) {
      if (!o.quiet)
        fmt::print(stderr, "gyromode: W is not symmetric, as ω² may be complex: {}. It is real, upper Hessenberg, by a unitary matrix\n",
                   why.what());
    }
  }
  std::error_code error;
  fs::create_directories(o.folder, error);
  if (!fs::is_directory(o.folder)) throw Unreadable(o.folder, "cannot be made a folder: a place to write matrices was expected");
  std::string names = write_matrices(o.folder, model);
  if (form)
    names += write_constant_form(o.folder, *second_order, *form, o, model.title);
  else if (o.realified)
    names += write_unitary_form(o.folder, *second_order, o, model.title);
  if (!o.quiet && model.ignored) fmt::print(stderr, "gyromode: {}\n", in_words(*model.ignored));
  if (!o.quiet) fmt::print(stderr, "gyromode: {} written to {}\n", names, o.folder);
  return ExitCode::done;
}

}  // namespace

void add_convert(CLI::App& program, int& code) {
  CLI::App* verb = program.add_subcommand("convert", "Write the matrices of a model as Matrix Market files");
  auto o = std::make_shared<Options>();
  o->source.add_to(*verb);
  verb->add_option("-o,--output", o->folder, "Folder for M.mtx, G.mtx, K.mtx (I.mtx, G.mtx for first-order models)")
      ->type_name("DIR")
      ->required();
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
      "Example:\n  gyromode convert models/three_springs.toml -o matrices\n  gyromode convert models/wiresaw.toml -o matrices --realified "
      "--transformation");
  verb->callback([o, &code] { code = guarded([&] { return run(*o); }); });
}

}  // namespace gyromode::app
