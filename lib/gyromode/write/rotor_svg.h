#pragma once

#include "gyromode/write/document.h"

#include <string>

namespace gyromode::io {

/// Whether the outlines of a result are those of shafts along one axis.
bool is_of_shafts(const ModesResult& result);
/// The modes of a rotor as a picture (SVG): a panel each, the shaft seen obliquely at rest, at t = 0 and a quarter of a
/// period later, discs as they tilt, bearings, and the orbits of places along it by the way they go round. Needs a
/// result with shapes.
std::string rotor_svg(const Model& model, const ModesResult& result, const ModeDetails& details, const Layout& layout);

}  // namespace gyromode::io
