#include "input.h"

#include "errors.h"

#include "gyromode/io/toml_table.h"
#include "gyromode/io/unit.h"
#include "gyromode/system/promise.h"

#include <fmt/format.h>

namespace gyromode::app {

void ModelSource::add_to(CLI::App& verb, bool tolerant) {
  verb.add_option("model", model, "Model file (TOML); or give the three matrices below")->type_name("MODEL");
  verb.add_option("--mass", mass, "Mass matrix M, Matrix Market")->type_name("M.mtx");
  verb.add_option("--gyroscopic", gyroscopic, "Gyroscopic matrix G (skew), Matrix Market; left out: G = 0")->type_name("G.mtx");
  verb.add_option("--stiffness", stiffness, "Stiffness matrix K, Matrix Market")->type_name("K.mtx");
  if (!tolerant) return;
  verb.add_option("--coupling-tolerance", coupling_tolerance,
                  "Couplings up to this fraction of the largest entry of their matrix are left out (default 0: none are)")
      ->type_name("FRACTION")
      ->check(CLI::Range(0.0, 0.1));
}

// A broken promise is known by its matrix; which files the matrices came from is known here.
template <class Reader>
io::Model promised(const std::string& files, Reader&& reader) {
  try {
    return reader();
  } catch (const io::BrokenLaw&) {
    throw;
  } catch (const BrokenPromise& e) {
    throw BrokenPromise(fmt::format("{}: {}", files, e.what()));
  }
}

io::Model ModelSource::read() const {
  const bool matrices = !mass.empty() || !gyroscopic.empty() || !stiffness.empty();
  if (model.empty() == !matrices) {
    throw UsageError(matrices ? "give a model file or --mass and --stiffness, not both"
                              : "no model: give a model file (gyromode modes models/rigid_body.toml) or --mass M.mtx [--gyroscopic G.mtx] --stiffness K.mtx");
  }
  if (!matrices) return promised(model, [&] { return io::read_model(model); });
  if (mass.empty() || stiffness.empty()) {
    throw UsageError(fmt::format("{} is missing: M and K are both needed (G may be left out)", mass.empty() ? "--mass" : "--stiffness"));
  }
  const std::string files = fmt::format("{}, {}{}{}", mass, gyroscopic, gyroscopic.empty() ? "" : ", ", stiffness);
  return promised(files, [&] { return io::read_matrices(mass, gyroscopic.empty() ? std::nullopt : std::optional<std::filesystem::path>(gyroscopic), stiffness); });
}

void ModelSource::remark_on_tolerance(const OutputOption& output) const {
  if (coupling_tolerance > 0) output.say(fmt::format("couplings up to {:.2g} of the largest entry are left out, as asked", coupling_tolerance));
}

void WindowOption::add_to(CLI::App& verb) {
  auto* b = verb.add_option("--below", below, "Modes with ω in [0, W); rad/s, or 5Hz, 300rpm")->type_name("W");
  auto* w = verb.add_option("--window", window, "Modes with ω in [A, B); each bound in rad/s or with its own unit, B may be left out")->type_name("A:B");
  b->excludes(w);
}

Window WindowOption::read() const {
  Window w;
  if (!below.empty()) {
    w.b = frequency_option("--below", below);
  } else if (!window.empty()) {
    const std::size_t colon = window.find(':');
    if (colon == std::string::npos) throw UsageError(fmt::format("--window {}: A:B was expected, such as 0.1:2 or 1Hz:50Hz", window));
    w.a = frequency_option("--window", window.substr(0, colon));
    const std::string end = window.substr(colon + 1);
    if (!end.empty()) w.b = frequency_option("--window", end);
  }
  if (!(w.a >= 0) || !(w.b > w.a)) throw UsageError(fmt::format("a window needs 0 ≤ A < B: [{}, {}) rad/s is none", w.a, w.b));
  return w;
}

double frequency_option(const std::string& option, const std::string& text) {
  const auto value = io::parse_frequency(text);
  if (!value) throw UsageError(fmt::format("{} {}: '{}' is no frequency: {} was expected", option, text, text, io::frequency_form));
  return *value;
}

}  // namespace gyromode::app
