#pragma once

#include "gyromode/models/model.h"

#include <cstdint>
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

/// Bytes of a model file, or of a matrix file, with those of the files that a model file names; what is not there
/// counts nothing. Large models take long, and a program may want to prepare.
std::uintmax_t bytes_to_read(const std::filesystem::path& file);

/// Where the matrices of a model are: a file each ("K.mtx", "model.mat:Stiff"), in any format that is read
/// (read_matrices_of()); or a container of several with the names that they have there.
struct MatrixFiles {
  std::filesystem::path mass;        ///< M
  std::filesystem::path gyroscopic;  ///< G; empty: 0
  std::filesystem::path stiffness;   ///< K; empty: 0
  std::filesystem::path container;   ///< instead of the three
  /// In the container: for M, G, K. Empty: what people call them (M, mass, MAAX, …)
  std::string mass_name;
  std::string gyroscopic_name;   ///< likewise
  std::string stiffness_name;    ///< likewise
  std::filesystem::path labels;  ///< names of the coordinates, one a line; empty: those of the matrix files, or q1 … qn
};

/// A model from matrix files. Matrices whose rows are named there (DMIG) are brought to one order by those names.
/// @throws Unreadable, LawBroken
Model read_matrices(const MatrixFiles& files, const Admission& admission = {});

}  // namespace gyromode
