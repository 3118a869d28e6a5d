#pragma once

#include "gyromode/write/document.h"

#include <string>

namespace gyromode::io {

/// A Campbell diagram as a picture: branches by whirl, lines of excitation with their intersections, veerings, and the
/// spins of flutter, in the units of the layout.
std::string campbell_svg(const Model& model, const Campbell& diagram, const Layout& layout);
/// The undamped critical-speed map: critical speeds over the logarithm of the parameter.
std::string critical_map_svg(const Model& model, const CriticalMap& map, const Layout& layout);

}  // namespace gyromode::io
