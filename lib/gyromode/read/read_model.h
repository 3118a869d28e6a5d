#pragma once

#include "gyromode/models/model.h"

#include <filesystem>
#include <optional>
#include <string_view>

namespace gyromode {

/// Reads a TOML model of kind "matrices", "first_order" or "spacecraft" (docs/model-files.md). Throws Unreadable (file,
/// line, column, value and what was expected) for what cannot be read, LawBroken for what breaks a law.
///
/// `admission`: how far matrices may be from (skew-)symmetric; the key `symmetrise` of the file may widen it, unless it
/// is strict.
Model read_model(const std::filesystem::path& file, const Admission& admission = {});

/// The same from text in memory; `name` stands for the file in messages, and matrix files are sought in its folder.
Model parse_model(std::string_view text, const std::filesystem::path& name, const Admission& admission = {});

/// A model from Matrix Market files; without a gyroscopic one G = 0.
Model read_matrices(const std::filesystem::path& mass, const std::optional<std::filesystem::path>& gyroscopic,
                    const std::filesystem::path& stiffness, const Admission& admission = {});

}  // namespace gyromode
