#pragma once

#include "gyromode/base/frequency_unit.h"
#include "gyromode/models/model.h"
#include "gyromode/spectrum/energy_share.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gyromode {

/// How a result is written.
enum class Format { table, json, csv, markdown, svg, html };

/// By name ("table", "json", "csv", "markdown", "svg", "html"), or nothing.
std::optional<Format> format_named(std::string_view name);
/// By the extension of a file: .json, .csv, .md, .svg, .html; table for the rest.
Format format_for(const std::filesystem::path& file);

/// Seconds spent.
struct Timings {
  double read = 0;   ///< of the model
  double solve = 0;  ///< of the answer
};

/// How a document looks.
struct Layout {
  Format format = Format::table;                             ///< how it is written
  FrequencyUnit unit = FrequencyUnit::radians;               ///< of frequencies, for people and in CSV
  FrequencyUnit spin_unit = FrequencyUnit::radians;          ///< of spins and critical speeds, likewise
  std::vector<std::pair<std::string, std::string>> options;  ///< what was asked for, as it was asked: "options" of JSON

  /// In rad/s.
  Layout(Format how = Format::table) : format(how) {}
};

/// What else may be said of modes.
struct ModeDetails {
  std::vector<Sensitivity> sensitivities;                          ///< to numbers of the model
  std::vector<std::optional<Whirl>> whirl;                         ///< of every mode, or empty
  double spin = 1;                                                 ///< rad/s, whose sign says which way is forward
  std::vector<std::string> names;                                  ///< of every mode, what the field calls it, or empty
  std::vector<std::vector<std::pair<std::string, Orbit>>> orbits;  ///< of every mode, of its places by name, or empty
  std::vector<std::vector<FixedAxesPart>> fixed_axes;              ///< of every mode of a model in turning axes, or empty
  std::vector<std::vector<EnergyShare>> energy_shares;             ///< of every mode, or empty
};
/// Whirl, orbits, frequencies in fixed axes and shares of energy of modes with their shapes, where the model has places
/// and parts.
ModeDetails details_of(const Model& model, const ModesResult& result);

/// The numbers that a verdict and a list of modes rest on, a line each, for people: components, index balance, counts,
/// the largest residual and error bound, the nearest roots of opposite energy sign.
std::vector<std::string> evidence(const ModesResult& result);

/// A result as text in the format asked for; html is a page of its own (html/report_page.h); svg, a picture of the
/// shapes, is for the modes of a spacecraft with shapes. JSON follows the public schemas (docs/results.md), 17
/// significant digits where needed. `version` of the schema gyromode/modes: 1, a shape with each mode; 2, shapes and
/// displacements of all modes as one block.
std::string document(const Model& model, const ModesResult& result, const Timings& timings, const Layout& layout, int version = 1,
                     const ModeDetails& details = {});
std::string document(const Model& model, const CountResult& result, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const StructureReport& report, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const ResponseReport& report, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const FrequencyReport& report, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const UnbalanceReport& report, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const CriticalSpeeds& speeds, const Timings& timings, const Layout& layout,
                     const std::vector<Sensitivity>& sensitivities = {});
std::string document(const Model& model, const Campbell& diagram, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const CriticalMap& map, const Timings& timings, const Layout& layout);
std::string document(const Model& model, const StabilityReport& report, const Timings& timings, const Layout& layout);

}  // namespace gyromode
