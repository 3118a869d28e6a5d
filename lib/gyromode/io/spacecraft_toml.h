#pragma once

#include "gyromode/io/toml_table.h"
#include "gyromode/spacecraft/spacecraft.h"

namespace gyromode::io {

/// A model of kind "spacecraft" (docs/model-files.md). Throws InputError for what cannot be read, BrokenLaw where a part breaks a law, with its place, and BrokenPromise for no equilibrium.
Spacecraft read_spacecraft(const TomlTable& table);

}  // namespace gyromode::io
