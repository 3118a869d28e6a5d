#pragma once

#include "gyromode/models/model.h"
#include "gyromode/write/document.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode::io {

using Json = nlohmann::ordered_json;

/// A column of a table: the key that its values have for programs, the heading with unit and the digits that people
/// see.
struct Column {
  enum class In { both, json, csv };
  std::string key;            ///< empty: for people only
  std::string heading = {};   ///< empty: for programs only
  std::string digits = "{}";  ///< of numbers, as fmt writes them
  In in = In::both;           ///< which programs
};

/// A value; `discarded` where there is none. Numbers that are not finite are null in JSON.
struct Cell {
  Json value;
  std::string words = {};  ///< what people see instead
};
inline const Json no_value = Json(Json::value_t::discarded);

/// Rows of one kind, made when they are asked for.
struct Table {
  std::string key;    ///< of the array in JSON; empty: not there
  std::string title;  ///< a line above, for people; may be empty
  std::vector<Column> columns;
  Index size = 0;
  std::function<std::vector<Cell>(Index row)> row = {};
  bool csv = false;  ///< the rows are (among) those of the CSV document
};

/// A document is described once, by calls to this; what comes of it is a table, Markdown, JSON or CSV.
class Writer {
 public:
  virtual ~Writer() = default;

  /// A fact: for programs under `key` (dots part the levels), for people a line. Either may be left empty.
  virtual void fact(std::string_view key, Json value, std::string_view heading = {}, const std::string& words = {}) = 0;
  /// A line for people alone.
  void say(std::string_view heading, const std::string& words) { fact({}, {}, heading, words); }
  virtual void table(const Table& table) = 0;
  /// A sentence, and lines that are drawn, for people alone.
  virtual void paragraph(const std::string& sentence) = 0;
  virtual void drawing(const std::string& lines) = 0;
  virtual std::string text() = 0;

  const Layout& layout() const { return layout_; }
  /// Version of the schema asked for.
  int version() const { return version_; }
  bool for_json() const { return layout_.format == Format::json || layout_.format == Format::html; }
  bool for_csv() const { return layout_.format == Format::csv; }

  /// A frequency or a spin, rad/s, for people and CSV; for JSON as it is.
  double frequency(double omega) const { return for_json() ? omega : in_unit(omega, layout_.unit); }
  double spin(double omega) const { return for_json() ? omega : in_unit(omega, layout_.spin_unit); }
  /// "ω [rad/s]", "f [Hz]", "f [rpm]"; "Ω [rad/s]", "speed [rpm]"; with `what` "gap [Hz]".
  std::string frequency_heading(std::string_view what = {}) const;
  std::string spin_heading() const;
  std::string frequency_unit() const { return std::string(to_string(layout_.unit)); }
  std::string spin_unit() const { return std::string(to_string(layout_.spin_unit)); }
  bool in_radians() const { return layout_.unit == FrequencyUnit::radians; }
  bool spins_in_radians() const { return layout_.spin_unit == FrequencyUnit::radians; }
  /// The key of a column: in CSV with the unit where that is not rad/s: "omega", "omega_hz".
  std::string frequency_key(std::string_view key) const { return key_in(key, layout_.unit); }
  std::string spin_key(std::string_view key) const { return key_in(key, layout_.spin_unit); }

 protected:
  explicit Writer(const Layout& layout, int version = 1) : layout_(layout), version_(version) {}

 private:
  std::string key_in(std::string_view key, FrequencyUnit unit) const;

  Layout layout_;
  int version_;
};

/// A document of that kind ("modes") and version about a model.
std::unique_ptr<Writer> writer(std::string_view kind, const Model& model, const Timings& timings, const Layout& layout, int version);

/// Describes each result.
void describe(const Model& model, const ModesResult& result, const ModeDetails& details, Writer& w);
void describe(const Model& model, const CountResult& result, Writer& w);
void describe(const Model& model, const StructureReport& report, Writer& w);
void describe(const Model& model, const CriticalSpeeds& speeds, Writer& w);
void describe(const Model& model, const CriticalMap& map, Writer& w);
void describe(const Model& model, const Campbell& diagram, Writer& w);
void describe(const Model& model, const StabilityReport& report, Writer& w);
void describe(const Model& model, const ResponseReport& report, Writer& w);
void describe(const Model& model, const FrequencyReport& report, Writer& w);
void describe(const Model& model, const UnbalanceReport& report, Writer& w);

/// How much numbers of the model move roots at `omega`; nothing where there are none.
void describe_sensitivities(const std::vector<Sensitivity>& all, const std::vector<double>& omega, Writer& w);

}  // namespace gyromode::io
