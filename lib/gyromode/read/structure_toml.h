#pragma once

#include "gyromode/formats/digest.h"
#include "gyromode/models/structure_mesh.h"
#include "gyromode/read/toml_table.h"

namespace gyromode::io {

/// The parts of kind = "structure". @throws Unreadable; LawBroken
StructureParts read_structure(const TomlTable& table, Digest& digest);
/// The same with G by its own file, key `gyroscopic`: matrices of any coordinates.
SparseMatrices read_sparse_matrices(const TomlTable& table, Digest& digest);

}  // namespace gyromode::io
