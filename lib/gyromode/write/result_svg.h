#pragma once

#include "gyromode/models/model.h"

#include "gyromode/spectrum/result.h"

#include <string>

namespace gyromode::io {

/// The mode shapes of a spacecraft as a picture (SVG): each from above, onto axes 1 and 2, and from the side, at the
/// moment t = 0 and a quarter of a period later, over the booms at rest. Needs a result with shapes.
std::string modes_svg(const Model& model, const ModesResult& result);

}  // namespace gyromode::io
