#include "help.h"
#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/lapack/memory.h"
#include "gyromode/version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace {

std::vector<std::string_view> verbs_of(const CLI::App& program) {
  std::vector<std::string_view> verbs;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) verbs.push_back(verb->get_name());
  return verbs;
}

// A model where a verb is due; else the nearest verb.
std::string instead_of(const std::string& word, const std::vector<std::string_view>& verbs) {
  std::error_code error;
  if (std::filesystem::exists(word, error)) return ": a verb comes first, such as gyromode modes " + word;
  return gyromode::suggestion(word, verbs);
}

// The first option that the verb does not know, with the nearest that it does.
std::string unknown_option(const CLI::App& program, int argc, char** argv, const std::string& otherwise) {
  for (const CLI::App* verb : program.get_subcommands()) {
    std::vector<std::string> names;
    for (const CLI::Option* option : verb->get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (int k = 2; k < argc; ++k) {
      const std::string word = std::string(argv[k]).substr(0, std::string(argv[k]).find('='));
      if (word.rfind("--", 0) != 0 || std::find(known.begin(), known.end(), word) != known.end()) continue;
      return "'" + word + "' is no option of " + verb->get_name() + gyromode::suggestion(word, known);
    }
  }
  return otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gyromode::app;
  gyromode::lapack::keep_freed_memory();
  CLI::App program{"gyromode: the vibration modes of what spins, M q̈ + G q̇ + K q = 0 with G skew, counted and certified.", "gyromode"};
  program.set_version_flag("-V,--version", std::string("gyromode ") + GYROMODE_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  gyromode modes models/rigid_body.toml\n"
      "  gyromode modes --mass M.mtx --gyroscopic G.mtx --stiffness K.mtx --below 50Hz -o modes.json\n"
      "  gyromode structure models/wiresaw.toml\n"
      "Exit codes: 0 done and certified, 1 usage, 2 unreadable input, 3 input against a law, 4 not certified complete, 70 internal error, "
      "130 interrupted (what is known by then is written, and marked).");
  program.formatter(std::make_shared<HelpText>());
  int code = 0;
  add_modes(program, code);
  add_structure(program, code);
  add_count(program, code);
  add_stability(program, code);
  add_campbell(program, code);
  add_critical(program, code);
  add_response(program, code);
  add_report(program, code);
  add_convert(program, code);
  const std::vector<std::string_view> verbs = verbs_of(program);
  std::vector<std::string> words(argv + 1, argv + argc);
  if (!words.empty() && words[0] == "help")
    words = words.size() > 1 ? std::vector<std::string>{words[1], "--help"} : std::vector<std::string>{"--help"};
  if (!words.empty() && words[0].rfind('-', 0) != 0 && std::find(verbs.begin(), verbs.end(), words[0]) == verbs.end()) {
    std::fprintf(stderr, "gyromode: '%s' is no verb%s (see gyromode --help)\n", words[0].c_str(), instead_of(words[0], verbs).c_str());
    return static_cast<int>(gyromode::ExitCode::wrong_usage);
  }
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 takes them
    program.parse(words);
  } catch (const CLI::ExtrasError& e) {
    std::fprintf(stderr, "gyromode: %s (see gyromode --help)\n", unknown_option(program, argc, argv, e.what()).c_str());
    return static_cast<int>(gyromode::ExitCode::wrong_usage);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(e);
    std::fprintf(stderr, "gyromode: %s (see gyromode --help)\n", e.what());
    return static_cast<int>(gyromode::ExitCode::wrong_usage);
  }
  return code;
}
