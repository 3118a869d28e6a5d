#pragma once

#include "gyromode/io/model.h"
#include "gyromode/modes/count.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/modes/effective_axes.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/motion/response.h"
#include "gyromode/spacecraft/held_booms.h"
#include "gyromode/sweep/stability_map.h"
#include "gyromode/structure/realify.h"

#include <optional>
#include <string>
#include <string_view>

namespace gyromode::io {

/// How a result is written.
enum class Format { table, json, csv, markdown, svg };

/// By name ("table", "json", "csv", "markdown", "svg"), or nothing.
std::optional<Format> format_named(std::string_view name);
/// By the extension of a file: .json, .csv, .md, .svg; table for the rest.
Format format_for(const std::filesystem::path& file);

/// Seconds spent.
struct Timings {
  double read = 0;
  double solve = 0;
};

/// H at a frequency, made real symmetric.
struct RealifiedAt {
  double omega = 0;
  Realified realified;
};

/// What `structure` reports beyond the facts themselves.
struct StructureReport {
  Structure structure;
  Stiffness stiffness;
  bool stiffness_applies = true;          ///< false for first-order models
  std::optional<RealifiedAt> at;
  std::vector<HeldBoom> held_booms;           ///< of a spacecraft: the poles of its booms
  std::vector<EffectiveAxes> effective_axes;  ///< of spacecraft that axes 1 and 2 do not part into in phase and in quadrature
};

/// What `stability` reports: the verdict with what it rests on.
struct StabilityReport {
  ModesResult result;
  /// The roots of opposite energy sign nearest to each other, rad/s; nothing where there are none.
  std::optional<std::array<double, 2>> opposite;
  /// The eigenvalue of (K, M) nearest to zero that is none, rad²/s²: how far K is from changing its index. Matrix models of second order.
  std::optional<double> stiffness;
  std::vector<std::string> varied;   ///< keys
  std::optional<StabilityMap> map;
};

/// A motion over time, as `response` reports it.
struct ResponseReport {
  Labels labels;             ///< of the rows of the history
  History history;
  bool rates = false;        ///< velocities as well
  std::vector<ModalShare> modal;
  Stability stability = Stability::unknown;
  double initial_energy = 0, zero_energy = 0, remainder_energy = 0;
  double departure = 0;      ///< of the decomposition, relative
  double phase_error = 0;    ///< rad, at the last time
  bool balance_closed = false;
  std::string remark;
};

/// H(ω)⁻¹f over a grid of frequencies.
struct FrequencyReport {
  Labels labels;
  FrequencyResponse response;
};

/// A result as text in the format asked for; svg, a picture of the shapes, is for the modes of a spacecraft with shapes. JSON follows the public schemas (docs/results.md), 17 significant digits where needed.
std::string document(const Model& model, const ModesResult& result, const Timings& timings, Format format);
std::string document(const Model& model, const CountResult& result, const Timings& timings, Format format);
std::string document(const Model& model, const StructureReport& report, const Timings& timings, Format format);
std::string document(const Model& model, const ResponseReport& report, const Timings& timings, Format format);
std::string document(const Model& model, const FrequencyReport& report, const Timings& timings, Format format);
std::string document(const Model& model, const StabilityReport& report, const Timings& timings, Format format);

}  // namespace gyromode::io
