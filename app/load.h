#pragma once

#include "gyromode/appendage/parts.h"
#include "gyromode/models/requests.h"
#include "gyromode/base/labels.h"

#include <string>
#include <vector>

namespace gyromode::app {

/// "impulse:LABEL=P,LABEL=P", "step:LABEL=F", "harmonic:LABEL=F@5Hz". Throws UsageError naming the text and what was
/// expected.
std::vector<Force> forces_of(const std::vector<std::string>& texts, const Labels& labels);

/// "LABEL=F,LABEL=F": the amplitude of a steady force, all of the texts together.
Vector amplitude_of(const std::vector<std::string>& texts, const Labels& labels);

/// "disk2=1e-4,station4=72 g mm@90deg": unbalances, kg m, with phases. Throws UsageError.
std::vector<Unbalance> unbalances_of(const std::vector<std::string>& texts);

/// "cable1@0.5", "beam1@1", "mass2".
std::vector<BoomPoint> points_of(const std::vector<std::string>& texts);

/// "LABEL,LABEL": the coordinates of the model that are named, ascending. Throws UsageError, beginning with the option.
std::vector<Index> coordinates_of(const std::string& option, const std::string& list, const Labels& labels);

/// "LABEL,LABEL": labels of the model, each once. Throws UsageError.
Labels labels_of(const std::string& list, const Labels& labels);

}  // namespace gyromode::app
