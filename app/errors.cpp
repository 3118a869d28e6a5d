#include "errors.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>
#include <string>

namespace gyromode::app {

namespace {

int failed(ExitCode code, const std::string& what) {
  if (code == ExitCode::internal_error)
    fmt::print(stderr, "gyromode: internal error: {} (please report it with the model)\n", what);
  else
    fmt::print(stderr, "gyromode: {}\n", what);
  return static_cast<int>(code);
}

}  // namespace

int guarded(const std::function<ExitCode()>& verb) {
  try {
    return static_cast<int>(verb());
  } catch (const Error& e) {
    return failed(e.exit_code(), e.what());
  } catch (const std::bad_alloc&) {
    return failed(ExitCode::unreadable_input, "the model does not fit into memory: a dense solver needs some 60 n² bytes");
  } catch (const std::exception& e) {
    return failed(ExitCode::internal_error, e.what());
  }
}

}  // namespace gyromode::app
