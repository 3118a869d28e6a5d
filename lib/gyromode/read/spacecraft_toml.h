#pragma once

#include "gyromode/read/toml_table.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode::io {

/// A model of kind "spacecraft" (docs/model-files.md). Throws Unreadable for what cannot be read, LawBroken where a
/// part breaks a law, with its place, or there is no equilibrium.
Spacecraft read_spacecraft(const TomlTable& table);

}  // namespace gyromode::io
