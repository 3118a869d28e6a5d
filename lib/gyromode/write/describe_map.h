#pragma once

#include "gyromode/write/writer.h"

namespace gyromode::io {

/// Verdicts over parameters with the critical values between them. `report` has a map.
void describe_map(const Model& model, const StabilityReport& report, Writer& w);

}  // namespace gyromode::io
