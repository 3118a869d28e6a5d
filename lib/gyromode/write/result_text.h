#pragma once

#include "gyromode/write/document.h"

namespace gyromode::io {

/// For people: aligned columns (Format::table) or Markdown.
std::string modes_text(const Model& model, const ModesResult& result, Format format);
std::string count_text(const Model& model, const CountResult& result, Format format);
std::string structure_text(const Model& model, const StructureReport& report, Format format);
std::string stability_text(const Model& model, const StabilityReport& report, Format format);

}  // namespace gyromode::io
