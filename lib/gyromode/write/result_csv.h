#pragma once

#include "gyromode/write/document.h"

namespace gyromode::io {

/// One row a mode; with shapes one column more a coordinate for each of re and im. Unstable motions follow as rows of their own kind.
std::string modes_csv(const Model& model, const ModesResult& result);
std::string count_csv(const CountResult& result);
std::string structure_csv(const Model& model, const StructureReport& report);
std::string stability_csv(const StabilityReport& report);

}  // namespace gyromode::io
