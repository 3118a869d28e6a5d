#pragma once

#include "gyromode/write/document.h"

#include <string>

namespace gyromode::io {

/// A stability map as a picture (SVG): over one parameter the growth rate, with the verdicts as bands and the critical
/// values; over two a chart of verdicts. Needs a report with a map.
std::string stability_svg(const Model& model, const StabilityReport& report, const Layout& layout);

}  // namespace gyromode::io
