#pragma once

#include "gyromode/read/toml_table.h"
#include "gyromode/rotor/rotor.h"

namespace gyromode::io {

/// A model of kind "rotor" (docs/model-files.md). Throws Unreadable, and LawBroken at the part that breaks a law.
Rotor read_rotor(const TomlTable& table);

}  // namespace gyromode::io
