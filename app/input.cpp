#include "input.h"

#include "errors.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/team.h"
#include "gyromode/spectrum/spectrum.h"
#include "gyromode/base/number.h"
#include "gyromode/read/toml_table.h"
#include "gyromode/sparse/factor_memory.h"
#include "gyromode/base/quantity.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace gyromode::app {

// A fraction of the largest entry; written so that NaN fails.
std::string no_small_fraction(const std::string& text) {
  constexpr double most = 0.1;
  const Parsed p = parse_real(text);
  if (p.outcome == Parsed::ok && p.value >= 0 && p.value <= most) return "";
  return fmt::format("'{}' where a fraction from 0 to {} was expected", text, most);
}

double fraction(const std::string& option, const std::string& text) {
  const Parsed p = parse_real(text);
  if (p.outcome == Parsed::ok && p.value >= 0 && p.value <= 2) return p.value;
  throw UsageError(fmt::format("{}={}: a fraction of the largest entry, from 0 to 2, was expected", option, text));
}

void ModelSource::add_to(CLI::App& verb) {
  verb.add_option("model", model, "Model file (TOML); or give matrices, below")->type_name("MODEL");
  verb.add_option("--mass", mass,
                  "Mass matrix M: Matrix Market, .npy, .mat, Harwell-Boeing, DMIG, OP4, CSV; FILE:NAME in a file of several")
      ->type_name("FILE");
  verb.add_option("--gyroscopic", gyroscopic, "Gyroscopic matrix G (skew), likewise; left out: G = 0")->type_name("FILE");
  verb.add_option("--stiffness", stiffness, "Stiffness matrix K, likewise")->type_name("FILE");
  verb.add_option("--matrices", container, "One file with M, G, K: .mat, .npz, DMIG, OP4")->type_name("FILE");
  verb.add_option("--names", names, "What they are called there: M=Mass,G=Gyro,K=Stiff")->type_name("M=NAME,…")->delimiter(',');
  verb.add_option("--labels", labels, "Names of the coordinates of such matrices, one a line")->type_name("FILE");
  verb.add_option("--coupling-tolerance", coupling_tolerance,
                  "Couplings up to this fraction of the largest entry of their matrix are left out (default 0: none are)")
      ->type_name("FRACTION")
      ->check(no_small_fraction);
  auto* take =
      verb.add_option("--symmetrise", symmetrise,
                      "Use the symmetric part of M and K and the skew part of G where they depart by up to TOL of the largest entry "
                      "(1e-3 if TOL is left out; what is rounding is let in without it)")
          ->type_name("[=TOL]")
          ->expected(0, 1)
          ->default_str("")
          ->option_text("[=TOL]");
  verb.add_flag("--strict", strict, "Refuse matrices that are not (skew-)symmetric to the last bit")->excludes(take);
  verb.add_option(
          "--memory", memory,
          "Large models: memory that the program may come to with a factorisation, such as 12GB; factors that need more are kept in "
          "files (default: what the machine has free)")
      ->type_name("BYTES");
  verb.add_option("--scratch", scratch, "The folder for such files (default: TMPDIR, else /var/tmp)")
      ->type_name("FOLDER")
      ->check(CLI::ExistingDirectory);
}

// A broken law is known by its matrix; which file that came from is known here.
template <class FileOf, class Reader>
Model located(FileOf&& file_of, Reader&& reader) {
  try {
    return reader();
  } catch (const LawBroken& e) {
    if (e.located()) throw;
    throw LawBroken(file_of(e.matrix()), 0, 0, e.what());
  }
}

// Departures from symmetry: --symmetrise alone takes what is no larger than people's typing leaves.
Admission ModelSource::admission() const {
  constexpr double unless_said = 1e-3;
  Admission a;
  a.strict = strict;
  if (symmetrise) a.symmetrise = symmetrise->empty() ? unless_said : fraction("--symmetrise", *symmetrise);
  return a;
}

Model ModelSource::admitted(Model m) const {
  gyromode::lapack::use_one_thread_for_small(std::ssize(m.labels()));
  return coupling_tolerance == 0 ? m : m.without_couplings(coupling_tolerance);
}

// M=Mass,K=Stiff
void ModelSource::name_matrices(MatrixFiles& files) const {
  for (const std::string& pair : names) {
    const std::size_t equals = pair.find('=');
    const std::string which = pair.substr(0, equals);
    std::string* name = which == "M"   ? &files.mass_name
                        : which == "G" ? &files.gyroscopic_name
                        : which == "K" ? &files.stiffness_name
                                       : nullptr;
    if (!name || equals == std::string::npos || equals + 1 == pair.size())
      throw UsageError(fmt::format("--names {}: M=NAME, G=NAME or K=NAME was expected, parted by commas", pair));
    if (!name->empty()) throw UsageError(fmt::format("--names: {} is given twice", which));
    *name = pair.substr(equals + 1);
  }
}

// 12GB, 800 MB, 4GiB; a bare number is bytes.
double bytes_option(const std::string& option, const std::string& text) {
  constexpr double least = 1e6;
  constexpr std::array<std::pair<std::string_view, double>, 10> units{{{"", 1},
                                                                       {"B", 1},
                                                                       {"KB", 1e3},
                                                                       {"MB", 1e6},
                                                                       {"GB", 1e9},
                                                                       {"TB", 1e12},
                                                                       {"KIB", 0x1p10},
                                                                       {"MIB", 0x1p20},
                                                                       {"GIB", 0x1p30},
                                                                       {"TIB", 0x1p40}}};
  const std::size_t end = text.find_first_not_of("0123456789.eE+-");
  std::string unit;
  for (const char c : end == std::string::npos ? "" : text.substr(end)) {
    if (c != ' ') unit += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  const Parsed number = parse_real(text.substr(0, end));
  const auto known = std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.first == unit; });
  if (number.outcome != Parsed::ok || known == units.end() || !(number.value * known->second >= least))
    throw UsageError(fmt::format("{} {}: an amount of memory from 1 MB on was expected, such as 12GB or 800MB", option, text));
  return number.value * known->second;
}

void ModelSource::limit_memory() const {
  if (!memory && !scratch) return;
  FactorMemory limit;
  if (memory) limit.most = bytes_option("--memory", *memory);
  if (scratch) limit.scratch = *scratch;
  set_factor_memory(limit);
}

Model ModelSource::read() const {
  limit_memory();
  const bool three = !mass.empty() || !gyroscopic.empty() || !stiffness.empty();
  const int given = int{!model.empty()} + int{three} + int{!container.empty()};
  if (given != 1) {
    throw UsageError(given > 1 ? "give a model file, --matrices, or --mass and --stiffness, not both"
                               : "no model: give a model file (gyromode modes models/rigid_body.toml), --mass M.mtx [--gyroscopic G.mtx] "
                                 "--stiffness K.mtx, or "
                                 "--matrices model.mat");
  }
  if (!names.empty() && container.empty()) throw UsageError("--names goes with --matrices");
  if (!labels.empty() && !model.empty()) throw UsageError("--labels goes with matrix files; a model file has the key labels");
  if (!model.empty()) return located([&](const auto&) { return model; }, [&] { return admitted(read_model(model, admission())); });
  MatrixFiles files{mass, gyroscopic, stiffness, container, {}, {}, {}, labels};
  name_matrices(files);
  if (!container.empty())
    return located([&](const auto&) { return container; }, [&] { return admitted(read_matrices(files, admission())); });
  if (mass.empty() || stiffness.empty())
    throw UsageError(fmt::format("{} is missing: M and K are both needed (G may be left out)", mass.empty() ? "--mass" : "--stiffness"));
  const auto file_of = [&](const std::string& matrix) { return matrix == "K" ? stiffness : matrix == "G" ? gyroscopic : mass; };
  return located(file_of, [&] { return admitted(read_matrices(files, admission())); });
}

void WindowOption::add_to(CLI::App& verb) {
  auto* b = verb.add_option("--below", below, "Modes with ω in [0, W); rad/s, or 5Hz, 300rpm")->type_name("W");
  auto* w = verb.add_option("--window", window, "Modes with ω in [A, B); each bound in rad/s or with its own unit, B may be left out")
                ->type_name("A:B");
  b->excludes(w);
}

Window WindowOption::read() const {
  Window w;
  if (below) {
    w.b = frequency_option("--below", *below);
  } else if (window) {
    const std::size_t colon = window->find(':');
    if (colon == std::string::npos) throw UsageError(fmt::format("--window {}: A:B was expected, such as 0.1:2 or 1Hz:50Hz", *window));
    w.a = frequency_option("--window", window->substr(0, colon));
    const std::string end = window->substr(colon + 1);
    if (!end.empty()) w.b = frequency_option("--window", end);
  }
  if (!(w.a >= 0) || !(w.b > w.a)) throw UsageError(fmt::format("a window needs 0 ≤ A < B: [{}, {}) rad/s is none", w.a, w.b));
  return w;
}

CLI::Validator whole_above_zero() {
  const auto reason = [](const std::string& text) -> std::string {
    const auto n = whole_number(text);
    return n && *n > 0 ? "" : fmt::format("'{}' is no whole number above 0", text);
  };
  return CLI::Validator(reason, "");
}

double frequency_option(const std::string& option, const std::string& text) {
  const auto value = parse_frequency(text);
  if (!value) throw UsageError(fmt::format("{} {}: '{}' is no frequency: {} was expected", option, text, text, frequency_form));
  constexpr double most = 1e30;  // beyond, squares leave the range of numbers
  if (std::abs(*value) > most)
    throw UsageError(fmt::format("{} {}: {:.3g} rad/s, where {:.0e} is the most that is computed with", option, text, *value, most));
  return *value;
}

}  // namespace gyromode::app
