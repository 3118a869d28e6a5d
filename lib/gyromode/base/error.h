#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gyromode {

/// What the program returns (docs/results.md).
enum class ExitCode {
  done = 0,
  wrong_usage = 1,
  unreadable_input = 2,
  broken_law = 3,
  not_certified = 4,
  internal_error = 70,
  interrupted = 130,
};

/// Everything that the library throws, but for std::bad_alloc. what() is one line that names the place, the value met
/// and what was expected.
class Error : public std::runtime_error {
 public:
  /// What the program returns for it.
  ExitCode exit_code() const noexcept { return code_; }

 protected:
  /// For the classes below.
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

 private:
  ExitCode code_;
};

/// An argument that a function does not take: a window with a > b, a vector of another length than the system.
class InvalidArgument : public Error {
 public:
  /// @param message what was met and what was expected
  explicit InvalidArgument(const std::string& message) : Error(ExitCode::wrong_usage, message) {}
};

/// Input that cannot be read: missing, malformed, of the wrong type or unit, not finite, or of sizes that do not fit.
/// "file:line:column: message".
class Unreadable : public Error {
 public:
  /// line and column count from 1; 0 leaves them out.
  Unreadable(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message);
  /// Of the file as a whole.
  Unreadable(const std::filesystem::path& file, const std::string& message) : Unreadable(file, 0, 0, message) {}
};

/// A law of mechanics that the input breaks: M not positive definite, K not symmetric, G not skew, an inertia against
/// the triangle inequality. The law, the size of the departure, the place in the matrix.
class LawBroken : public Error {
 public:
  /// @param message the law and what breaks it
  explicit LawBroken(const std::string& message) : Error(ExitCode::broken_law, message) {}
  /// The same with the place in a file where it was broken.
  LawBroken(const std::filesystem::path& file, std::size_t line, std::size_t column, const std::string& message);

  /// A law that one matrix of the model breaks: "M", "G", "K", or "I" of first order.
  static LawBroken of(std::string_view matrix, const std::string& message);

  /// Whether what() starts with a file.
  bool located() const noexcept { return located_; }
  /// The matrix that breaks the law; empty where it is no single one.
  const std::string& matrix() const noexcept { return matrix_; }

 private:
  bool located_ = false;
  std::string matrix_;
};

/// A method or question that does not fit the model; why, and what to use instead.
class NotApplicable : public Error {
 public:
  /// @param message why, and what to use instead
  explicit NotApplicable(const std::string& message) : Error(ExitCode::broken_law, message) {}
};

/// A model too large for a dense method on this build (LAPACK indexes its workspace with 32 bits).
class TooLarge : public Error {
 public:
  /// @param message the size, and what is possible
  explicit TooLarge(const std::string& message) : Error(ExitCode::unreadable_input, message) {}
};

/// An iteration of LAPACK did not converge, or LAPACK refused an argument. Neither is the model's fault.
class NotConverged : public Error {
 public:
  /// @param message the routine and what it returned
  explicit NotConverged(const std::string& message) : Error(ExitCode::internal_error, message) {}
};

/// Long work ended by Progress before it had a result.
class Interrupted : public Error {
 public:
  /// @param message what was going on
  explicit Interrupted(const std::string& message = "interrupted before anything was known") : Error(ExitCode::interrupted, message) {}
};

}  // namespace gyromode
