#pragma once

#include "gyromode/appendage/parts.h"
#include "gyromode/motion/state.h"
#include "gyromode/base/labels.h"

#include <string>
#include <vector>

namespace gyromode::app {

/// "impulse:LABEL=P,LABEL=P", "step:LABEL=F", "harmonic:LABEL=F@5Hz". Throws UsageError naming the text and what was
/// expected.
std::vector<Force> forces_of(const std::vector<std::string>& texts, const Labels& labels);

/// "LABEL=F,LABEL=F": the amplitude of a steady force, all of the texts together.
Vector amplitude_of(const std::vector<std::string>& texts, const Labels& labels);

/// "cable1@0.5", "beam1@1", "mass2".
std::vector<BoomPoint> points_of(const std::vector<std::string>& texts);

/// "LABEL,LABEL": labels of the model, each once. Throws UsageError.
Labels labels_of(const std::string& list, const Labels& labels);

}  // namespace gyromode::app
