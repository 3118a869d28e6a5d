#include "gyromode/write/document.h"

#include "gyromode/write/result_csv.h"
#include "gyromode/write/result_json.h"
#include "gyromode/write/result_svg.h"
#include "gyromode/write/result_text.h"

namespace gyromode::io {

std::optional<Format> format_named(std::string_view name) {
  if (name == "table") return Format::table;
  if (name == "json") return Format::json;
  if (name == "csv") return Format::csv;
  if (name == "markdown") return Format::markdown;
  if (name == "svg") return Format::svg;
  return std::nullopt;
}

Format format_for(const std::filesystem::path& file) {
  const auto extension = file.extension();
  if (extension == ".json") return Format::json;
  if (extension == ".csv") return Format::csv;
  if (extension == ".md") return Format::markdown;
  if (extension == ".svg") return Format::svg;
  return Format::table;
}

std::string document(const Model& model, const ModesResult& result, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return modes_json(model, result, timings);
    case Format::csv: return modes_csv(model, result);
    case Format::svg: return modes_svg(model, result);
    default: return modes_text(model, result, format);
  }
}

std::string document(const Model& model, const CountResult& result, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return count_json(model, result, timings);
    case Format::csv: return count_csv(result);
    default: return count_text(model, result, format);
  }
}

std::string document(const Model& model, const StructureReport& report, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return structure_json(model, report, timings);
    case Format::csv: return structure_csv(model, report);
    default: return structure_text(model, report, format);
  }
}

std::string document(const Model& model, const StabilityReport& result, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return stability_json(model, result, timings);
    case Format::csv: return stability_csv(result);
    default: return stability_text(model, result, format);
  }
}

}  // namespace gyromode::io
