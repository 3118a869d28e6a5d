#pragma once

#include "gyromode/base/types.h"
#include "gyromode/models/parameter_keys.h"

#include <optional>
#include <string_view>
#include <vector>

namespace gyromode {

/// A matrix whose entries are parameters: "stiffness[0][1]". A change of one entry is one of its mirror image too, with
/// the other sign where the matrix is skew.
struct MatrixOfParameters {
  std::string_view name;
  Matrix* matrix = nullptr;
  bool skew = false;
};

/// The entries on and above the diagonal of matrices up to order 12, and the first of larger ones: what is worth
/// listing. All can be named.
std::vector<Parameter> listed_entries(const std::vector<MatrixOfParameters>& matrices);

/// The first entry that a key names.
std::optional<Parameter> entry_named(const std::vector<MatrixOfParameters>& matrices, std::string_view key);

/// Gives the entries that a key names a value; false where it names none.
bool set_entries(const std::vector<MatrixOfParameters>& matrices, const ParameterValue& value);

/// Whether all entries that a key names have that value: not where a later value of several took one of them.
bool entries_have(const std::vector<MatrixOfParameters>& matrices, const ParameterValue& value);

}  // namespace gyromode
