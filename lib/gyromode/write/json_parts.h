#pragma once

#include "gyromode/write/document.h"

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// What the JSON documents are made of.
using Json = nlohmann::ordered_json;

Json number(double x);  ///< null where it is not finite
Json bounds(const Window& w);
Json labels_of(const Labels& labels, const std::vector<Index>& coordinates);
Json rows_of(const Matrix& a);
Json complex_rows(const ComplexMatrix& a);
/// What every document starts with.
Json head(std::string_view schema, const Model& model, const Timings& timings);
Json structure_facts(const Model& model, const Structure& s, const InertiaOfK& k, bool has_stiffness);
Json balance_json(const IndexBalance& b);
Json modes_array(const Model& model, const std::vector<Mode>& modes);
Json unstable_array(const Model& model, const std::vector<UnstableMode>& modes);
std::string text(const Json& j);

}  // namespace gyromode::io
