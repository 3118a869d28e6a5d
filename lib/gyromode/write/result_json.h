#pragma once

#include "gyromode/write/document.h"

namespace gyromode::io {

std::string modes_json(const Model& model, const ModesResult& result, const Timings& timings);
std::string count_json(const Model& model, const CountResult& result, const Timings& timings);
std::string structure_json(const Model& model, const StructureReport& report, const Timings& timings);
std::string stability_json(const Model& model, const StabilityReport& report, const Timings& timings);

}  // namespace gyromode::io
