#pragma once

#include "gyromode/write/document.h"

#include <string>
#include <vector>

namespace gyromode::io {

/// Amplitudes over frequency or speed, logarithmic, with the resonances; displacements over time. Of several curves the
/// six that reach highest.
std::string frequency_response_svg(const Model& model, const FrequencyReport& report, const Layout& layout);
std::string unbalance_svg(const Model& model, const UnbalanceReport& report, const Layout& layout);
std::string motion_svg(const Model& model, const ResponseReport& report);

/// The rows of `peaks` (one a curve) that reach highest, at most `most`, in their order.
std::vector<std::size_t> highest(const std::vector<double>& peaks, std::size_t most);
/// The largest half axis of each place over the speeds of the grid that are no resonances.
std::vector<double> peaks_of(const UnbalanceReport& report);

}  // namespace gyromode::io
