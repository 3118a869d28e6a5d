#pragma once

#include "gyromode/write/document.h"
#include "gyromode/write/grid.h"

#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

/// What the documents for people are made of.
std::string plural(Index n, std::string_view one);
std::string written(const Grid& grid, Format format);
/// "key: value" lines above a table; a bullet each in Markdown.
std::string fact(Format format, std::string_view key, const std::string& value);
std::string heading(Format format, const std::string& title);
/// The labels of some coordinates, the first dozen by name.
std::string joined(const Labels& labels, const std::vector<Index>& coordinates);

std::string model_line(const Model& model);
std::string class_words(const Model& model, const Structure& s);
std::string stiffness_words(const InertiaOfK& k);
std::string stability_words(Stability s);
std::string window_words(const Window& w);
std::string balance_words(const IndexBalance& b);
std::string complex_cell(const Complex& z);
std::string frequency_table(const std::vector<Mode>& modes, Format format);
/// A residual or an error bound; a dash where it was not measured.
std::string measured(double x);
std::string unstable_table(const std::vector<UnstableMode>& modes, Format format);

}  // namespace gyromode::io
