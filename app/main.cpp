#include "verbs.h"

#include "gyromode/base/error.h"
#include "gyromode/base/nearest.h"
#include "gyromode/lapack/memory.h"
#include "gyromode/version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

namespace {

std::vector<std::string_view> verbs_of(const CLI::App& program) {
  std::vector<std::string_view> verbs;
  for (const CLI::App* verb : program.get_subcommands([](const CLI::App*) { return true; })) verbs.push_back(verb->get_name());
  return verbs;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gyromode::app;
  gyromode::lapack::keep_freed_memory();
  CLI::App program{"gyromode: the vibration modes of what spins, M q̈ + G q̇ + K q = 0 with G skew, counted and certified.", "gyromode"};
  program.set_version_flag("--version", std::string("gyromode ") + GYROMODE_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  gyromode modes models/rigid_body.toml\n"
      "  gyromode modes --mass M.mtx --gyroscopic G.mtx --stiffness K.mtx --below 50Hz -o modes.json\n"
      "  gyromode structure models/wiresaw.toml\n"
      "Exit codes: 0 done and certified, 1 usage, 2 unreadable input, 3 input against a law, 4 not certified complete, 70 internal error, "
      "130 interrupted (what is known by then is written, and marked).");
  int code = 0;
  add_modes(program, code);
  add_structure(program, code);
  add_count(program, code);
  add_stability(program, code);
  add_response(program, code);
  add_convert(program, code);
  const std::vector<std::string_view> verbs = verbs_of(program);
  if (argc > 1 && argv[1][0] != '-' && std::find(verbs.begin(), verbs.end(), argv[1]) == verbs.end()) {
    std::fprintf(stderr, "gyromode: '%s' is no verb: did you mean '%s'? (see gyromode --help)\n", argv[1],
                 gyromode::nearest(argv[1], verbs).c_str());
    return static_cast<int>(gyromode::ExitCode::wrong_usage);
  }
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) return program.exit(e);
    std::fprintf(stderr, "gyromode: %s (see gyromode --help)\n", e.what());
    return static_cast<int>(gyromode::ExitCode::wrong_usage);
  }
  return code;
}
