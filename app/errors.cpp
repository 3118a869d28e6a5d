#include "errors.h"

#include "exit_code.h"

#include "gyromode/dense/spectrum.h"
#include "gyromode/io/input_error.h"
#include "gyromode/lapack/status.h"
#include "gyromode/system/promise.h"

#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace gyromode::app {

namespace {

int failed(ExitCode code, const char* what) {
  fmt::print(stderr, "gyromode: {}\n", what);
  return code;
}

}  // namespace

int guarded(const std::function<int()>& verb) {
  try {
    return verb();
  } catch (const UsageError& e) {
    return failed(wrong_usage, e.what());
  } catch (const io::InputError& e) {
    return failed(unreadable_input, e.what());
  } catch (const BrokenPromise& e) {
    return failed(broken_law, e.what());
  } catch (const dense::MethodDoesNotApply& e) {
    return failed(broken_law, e.what());
  } catch (const lapack::TooLarge& e) {
    return failed(unreadable_input, e.what());
  } catch (const std::invalid_argument& e) {
    return failed(wrong_usage, e.what());
  } catch (const std::bad_alloc&) {
    return failed(unreadable_input, "the model does not fit into memory: a dense solver needs some 60 n² bytes");
  } catch (const std::exception& e) {
    return failed(internal_error, fmt::format("internal error: {} (please report it with the model)", e.what()).c_str());
  }
}

}  // namespace gyromode::app
