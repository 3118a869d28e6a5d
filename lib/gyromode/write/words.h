#pragma once

#include "gyromode/models/model_kind.h"
#include "gyromode/models/model.h"
#include "gyromode/write/writer.h"

#include <numbers>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// What documents say in words.
std::string model_words(const Model& model);
std::string class_words(const Model& model, const Structure& s);
std::string stiffness_words(const InertiaOfK& k);
std::string stability_words(Stability s);
/// In rad/s, or in another unit.
std::string window_words(const Window& w, FrequencyUnit unit = FrequencyUnit::radians);
std::string balance_words(const IndexBalance& b);
std::string coverage_words(const Coverage& c, FrequencyUnit unit = FrequencyUnit::radians);
/// The labels of some coordinates, the first dozen by name.
std::string joined(const Labels& labels, const std::vector<Index>& coordinates);
std::string complex_words(const Complex& z);
/// The label of the largest entry; empty where there is no shape.
std::string largest_in(const Labels& labels, const ComplexVector& shape);

/// What several documents hold, for programs.
Json bounds(const Window& w);
Json labels_of(const Labels& labels, const std::vector<Index>& coordinates);
Json rows_of(const Matrix& a);
Json complex_rows(const ComplexMatrix& a);
/// Displacements of the points of "geometry", in their order; nothing where there are none.
Json displacements(const std::vector<ComplexMatrix>& field);
Json shape_json(const Labels& labels, const ComplexVector& shape);
inline double hertz(double omega) { return omega / (2 * std::numbers::pi); }

/// " of the symmetrised matrices", where what was dropped does more to a root than its error bound.
std::string repaired_words(const std::vector<Repair>& repairs);
void describe_repairs(const std::vector<Repair>& repairs, Writer& w);
void describe_class(const Model& model, const Structure& s, const InertiaOfK& k, bool has_stiffness, Writer& w);
void describe_balance(const IndexBalance& b, Writer& w);
/// `unit` of its window, for people.
void describe_coverage(const Coverage& c, FrequencyUnit unit, Writer& w);
/// Modes as people read them.
Table modes_lines(const std::vector<Mode>& modes, const ModeDetails& details, const Writer& w);
/// Modes for programs, under `key` in JSON; with their shapes where they have some.
Table modes_table(const Model& model, std::string key, const std::vector<Mode>& modes, const Writer& w, bool shapes_in_csv = false,
                  const ModeDetails& details = {});
Table unstable_table(const Model& model, const std::vector<UnstableMode>& modes, const Writer& w, bool shapes_in_csv);

}  // namespace gyromode::io
