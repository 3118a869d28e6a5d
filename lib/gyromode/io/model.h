#pragma once

#include "gyromode/base/error.h"
#include "gyromode/spacecraft/spacecraft.h"
#include "gyromode/structure/ignored_couplings.h"
#include "gyromode/system/first_order_system.h"
#include "gyromode/system/system.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gyromode::io {

/// What a model file declares to be known of it, for whoever wants to check: never used in a computation.
struct KnownValues {
  std::vector<double> frequencies;   ///< rad/s, ascending
  std::string stability;             ///< a word of the verdict, or empty
  std::string system_class;          ///< quadrature, hidden_quadrature, general or transcendental, or empty
};

/// A model as read: the system, and where it comes from.
struct Model {
  std::string title;
  std::string reference;
  std::string kind;      ///< "matrices", "first_order" or "spacecraft"
  std::string sha256;    ///< of the model file followed by its matrix files, in the order M, G, K, per-spin ones (I, G)
  std::variant<System, FirstOrderSystem, Spacecraft> system;
  std::optional<double> spin;  ///< rad/s, where the system depends on it
  KnownValues known;
  std::optional<IgnoredCouplings> ignored = std::nullopt;  ///< where `system` is that of the file without its weak couplings

  Index size() const;
  const Labels& labels() const;
};

/// Reads a TOML model of kind "matrices", "first_order" or "spacecraft" (docs/model-files.md). Throws Unreadable (file, line, column, value and what was
/// expected) for what cannot be read, LawBroken for what breaks a law.
Model read_model(const std::filesystem::path& file);

/// The same from text in memory; `name` stands for the file in messages, and matrix files are sought in its folder.
Model parse_model(std::string_view text, const std::filesystem::path& name);

/// A model from Matrix Market files; without a gyroscopic one G = 0.
Model read_matrices(const std::filesystem::path& mass, const std::optional<std::filesystem::path>& gyroscopic, const std::filesystem::path& stiffness);

}  // namespace gyromode::io
