#pragma once

#include "gyromode/formats/matrix_market.h"
#include "gyromode/models/model.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace gyromode {

/// A matrix that `convert` writes.
struct ConvertedMatrix {
  std::string name;                       ///< of the file, without .mtx
  Matrix matrix;                          ///< itself
  Symmetry symmetry = Symmetry::general;  ///< that the file declares
  std::string meaning;                    ///< for the comment of the file
};

/// What `convert` writes.
struct Conversion {
  std::vector<ConvertedMatrix> matrices;  ///< one a file
  std::string remark;                     ///< for people; may be empty
  Labels labels;                          ///< of the coordinates of M, G, K
  /// of a model that depends on its spin: what a model file holds instead of the matrices at one spin
  std::shared_ptr<const SpinFamily> family;
};

/// The matrices of a model: M, G, K; I, G. `realified`: also W, n × n, whose eigenvalues are ω²: symmetric in the
/// quadrature class, visible or hidden, and for K ≥ 0 (theory §3a), else upper Hessenberg (theory §3e).
/// `transformation`: with it U = [displacement velocity], n × 2n, D and Q where W = DᵀD, Q1 and Q2 where W is not
/// symmetric.
/// @throws NotApplicable for `realified` of a model of first order, or a model that is not made of matrices
Conversion converted(const Model& model, bool realified, bool transformation);

/// Writes them: into a folder, a file each (`format`: mtx, npy or csv); or as one file by its extension, .mat (MATLAB
/// v5), .npz (NumPy), .toml (a model file: M, G, K with their parts that go with the spin, or I, G; labels, orbits and
/// frame). @returns what was written, for people. @throws Unreadable where the place cannot be written; InvalidArgument
/// for another format or extension
std::string write_matrices(const Conversion& conversion, const Model& model, const std::filesystem::path& target,
                           const std::string& format = "mtx");

}  // namespace gyromode
