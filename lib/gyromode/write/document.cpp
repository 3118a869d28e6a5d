#include "gyromode/write/document.h"

#include "gyromode/html/report_page.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/write/campbell_svg.h"

#include "gyromode/write/response_svg.h"
#include "gyromode/write/result_svg.h"
#include "gyromode/write/rotor_svg.h"
#include "gyromode/write/stability_svg.h"
#include "gyromode/write/writer.h"

namespace gyromode {

std::optional<Format> format_named(std::string_view name) {
  if (name == "table") return Format::table;
  if (name == "json") return Format::json;
  if (name == "csv") return Format::csv;
  if (name == "markdown") return Format::markdown;
  if (name == "svg") return Format::svg;
  if (name == "html") return Format::html;
  return std::nullopt;
}

Format format_for(const std::filesystem::path& file) {
  const auto extension = file.extension();
  if (extension == ".json") return Format::json;
  if (extension == ".csv") return Format::csv;
  if (extension == ".md") return Format::markdown;
  if (extension == ".svg") return Format::svg;
  if (extension == ".html" || extension == ".htm") return Format::html;
  return Format::table;
}

namespace {

using namespace io;

// A page is made of the document as JSON.
std::string finished(Writer& w, std::string_view kind, const Layout& layout) {
  return layout.format == Format::html ? report_page({{std::string(kind), w.text()}}) : w.text();
}

template <class Result>
std::string written(std::string_view kind, const Model& model, const Result& result, const Timings& timings, const Layout& layout,
                    int version = 1) {
  const std::unique_ptr<Writer> w = writer(kind, model, timings, layout, version);
  describe(model, result, *w);
  return finished(*w, kind, layout);
}

}  // namespace

std::string document(const Model& model, const ModesResult& result, const Timings& timings, const Layout& layout, int version,
                     const ModeDetails& details) {
  if (layout.format == Format::svg) return is_of_shafts(result) ? rotor_svg(model, result, details, layout) : modes_svg(model, result);
  const std::unique_ptr<Writer> w = writer("modes", model, timings, layout, version);
  describe(model, result, details, *w);
  describe_sensitivities(details.sensitivities, result.frequencies(), *w);
  return finished(*w, "modes", layout);
}

ModeDetails details_of(const Model& model, const ModesResult& result) {
  ModeDetails d;
  d.spin = model.spin.value_or(1);
  const std::vector<OrbitCoordinates> places = model.body->orbits();
  const bool turning = model.frame == Frame::turning && model.spin;
  for (const Mode& m : result.modes) {
    const bool there = m.shape.size() > 0 && m.kind != ModeKind::rigid_body;
    d.whirl.push_back(there ? whirl_of(m.shape, places, model.spin.value_or(1)) : std::nullopt);
    d.orbits.emplace_back();
    for (const OrbitCoordinates& p : places) {
      if (there && !p.name.empty()) d.orbits.back().emplace_back(p.name, orbit_of(m.shape, p));
    }
    d.fixed_axes.push_back(there && turning ? in_fixed_axes(m.shape, m.omega, *model.spin, places) : std::vector<FixedAxesPart>{});
    d.energy_shares.push_back(there ? model.body->energy_shares(m, result.outlines) : std::vector<EnergyShare>{});
    d.names.push_back(model.body->name_of(m, d.energy_shares.back()));
  }
  return d;
}
std::string document(const Model& model, const CountResult& result, const Timings& timings, const Layout& layout) {
  return written("count", model, result, timings, layout);
}
std::string document(const Model& model, const StructureReport& report, const Timings& timings, const Layout& layout) {
  return written("structure", model, report, timings, layout);
}
std::string document(const Model& model, const CriticalSpeeds& speeds, const Timings& timings, const Layout& layout,
                     const std::vector<Sensitivity>& sensitivities) {
  const std::unique_ptr<Writer> w = writer("critical", model, timings, layout, 1);
  describe(model, speeds, *w);
  std::vector<double> omega;
  for (const CriticalSpeed& c : speeds.speeds) omega.push_back(c.speed);
  describe_sensitivities(sensitivities, omega, *w);
  return finished(*w, "critical", layout);
}
std::string document(const Model& model, const Campbell& diagram, const Timings& timings, const Layout& layout) {
  return layout.format == Format::svg ? campbell_svg(model, diagram, layout) : written("campbell", model, diagram, timings, layout);
}
std::string document(const Model& model, const CriticalMap& map, const Timings& timings, const Layout& layout) {
  return layout.format == Format::svg ? critical_map_svg(model, map, layout) : written("critical", model, map, timings, layout);
}
std::string document(const Model& model, const StabilityReport& report, const Timings& timings, const Layout& layout) {
  if (layout.format == Format::svg) return stability_svg(model, report, layout);
  return written("stability", model, report, timings, layout);
}
std::string document(const Model& model, const ResponseReport& report, const Timings& timings, const Layout& layout) {
  return layout.format == Format::svg ? motion_svg(model, report) : written("response", model, report, timings, layout);
}
std::string document(const Model& model, const FrequencyReport& report, const Timings& timings, const Layout& layout) {
  if (layout.format == Format::svg) return frequency_response_svg(model, report, layout);
  return written("frequency_response", model, report, timings, layout);
}
std::string document(const Model& model, const UnbalanceReport& report, const Timings& timings, const Layout& layout) {
  if (layout.format == Format::svg) return unbalance_svg(model, report, layout);
  return written("unbalance_response", model, report, timings, layout);
}

}  // namespace gyromode
