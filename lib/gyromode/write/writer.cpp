#include "gyromode/write/writer.h"

#include "gyromode/base/lines.h"
#include "gyromode/formats/csv.h"
#include "gyromode/lapack/library.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/version.h"
#include "gyromode/write/grid.h"
#include "gyromode/write/words.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace gyromode::io {

namespace {

// "2026-11-28T01:30:00Z".
std::string now() { return fmt::format("{:%FT%TZ}", fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()))); }

class JsonWriter : public Writer {
 public:
  JsonWriter(std::string_view kind, const Model& model, const Timings& timings, const Layout& layout, int version)
      : Writer(layout, version) {
    root_["schema"] = fmt::format("gyromode/{}/{}", kind, version);
    root_["model"] = {{"title", model.title},
                      {"sha256", model.sha256},
                      {"coordinates", model.size()},
                      {"kind", model.kind},
                      {"frame", model.frame == Frame::unknown ? Json(nullptr) : Json(to_string(model.frame))}};
    if (model.ignored) root_["model"]["couplings_left_out"] = {{"up_to", model.ignored->tolerance}, {"largest", model.ignored->largest}};
    root_["versions"] = {{"gyromode", gyromode::version()}, {"blas", lapack::library()}};
    root_["units"] = frequency_unit();
    root_["parameters"] = Json::object();
    for (const Parameter& p : model.body->named_parameters()) root_["parameters"][p.key] = p.value;
    root_["options"] = Json::object();
    for (const auto& [option, value] : layout.options) root_["options"][option] = value;
    root_["timings"] = {{"at", now()}, {"read_s", timings.read}, {"solve_s", timings.solve}};
  }

  void fact(std::string_view key, Json value, std::string_view, const std::string&) override {
    if (!key.empty() && !value.is_discarded()) place(key) = std::move(value);
  }
  void table(const Table& t) override {
    if (t.key.empty()) return;
    Json& rows = place(t.key) = Json::array();
    for (Index k = 0; k < t.size; ++k) {
      Json row = Json::object();
      std::vector<Cell> cells = t.row(k);
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const Column& column = t.columns[c];
        if (!column.key.empty() && column.in != Column::In::csv && !cells[c].value.is_discarded())
          row[column.key] = std::move(cells[c].value);
      }
      rows.push_back(std::move(row));
    }
  }
  void paragraph(const std::string&) override {}
  void drawing(const std::string&) override {}
  std::string text() override { return root_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

 private:
  Json& place(std::string_view key) {
    Json* at = &root_;
    for (std::size_t dot = key.find('.'); dot != std::string_view::npos; dot = key.find('.')) {
      at = &(*at)[std::string(key.substr(0, dot))];
      key.remove_prefix(dot + 1);
    }
    return (*at)[std::string(key)];
  }

  Json root_;
};

class CsvWriter : public Writer {
 public:
  explicit CsvWriter(const Layout& layout) : Writer(layout) {}

  void fact(std::string_view, Json, std::string_view, const std::string&) override {}
  void table(const Table& t) override {
    if (!t.csv) return;
    const auto line = [&](auto&& field) {
      bool first = true;
      for (std::size_t c = 0; c < t.columns.size(); ++c) {
        if (t.columns[c].key.empty() || t.columns[c].in == Column::In::json) continue;
        if (!first) text_ += ',';
        first = false;
        field(c);
      }
      text_ += '\n';
    };
    if (text_.empty()) line([&](std::size_t c) { text_ += csv_field(t.columns[c].key); });
    for (Index k = 0; k < t.size; ++k) {
      const std::vector<Cell> cells = t.row(k);
      line([&](std::size_t c) { add(cells[c].value); });
    }
  }
  void paragraph(const std::string&) override {}
  void drawing(const std::string&) override {}
  std::string text() override { return std::move(text_); }

 private:
  void add(const Json& v) {
    if (v.is_null() || v.is_discarded()) return;
    if (v.is_string())
      text_ += csv_field(v.get_ref<const std::string&>());
    else if (v.is_number_float())
      text_ += std::isnan(v.get<double>()) ? std::string() : fmt::format("{}", v.get<double>());
    else
      text_ += v.dump();
  }

  std::string text_;
};

// For people: aligned columns, or Markdown.
class TextWriter : public Writer {
 public:
  TextWriter(const Model& model, const Layout& layout) : Writer(layout), markdown_(layout.format == Format::markdown) {
    text_ = markdown_ ? "## " + markdown_escaped(model_words(model)) + "\n"
                      : wrapped_with_indent(model_words(model), line_columns - 2, 2) + "\n";
  }

  void fact(std::string_view, Json, std::string_view heading, const std::string& words) override {
    if (words.empty()) return;
    part(!in_facts_);
    if (markdown_) {
      const std::string shown = markdown_escaped(words);
      text_ +=
          heading.empty() ? fmt::format("  {}\n", shown) : fmt::format("- **{}**: {}\n", markdown_escaped(std::string(heading)), shown);
    } else {
      text_ += fmt::format("{:<11} {}\n", heading, wrapped_with_indent(words, line_columns - heading_columns, heading_columns));
    }
    in_facts_ = true;
  }
  void table(const Table& t) override {
    std::vector<std::string> headings;
    for (const Column& c : t.columns) {
      if (!c.heading.empty()) headings.push_back(c.heading);
    }
    if (t.size == 0 || headings.empty()) return;
    Grid grid(headings);
    for (Index k = 0; k < t.size; ++k) {
      const std::vector<Cell> cells = t.row(k);
      std::vector<std::string> row;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        if (!t.columns[c].heading.empty()) row.push_back(seen(cells[c], t.columns[c].digits));
      }
      grid.add(std::move(row));
    }
    part(true);
    if (!t.title.empty()) text_ += markdown_ ? markdown_escaped(t.title) + "\n\n" : wrapped_with_indent(t.title, line_columns, 0) + "\n";
    text_ += markdown_ ? grid.markdown() : grid.aligned();
    in_facts_ = false;
  }
  void paragraph(const std::string& sentence) override {
    part(true);
    text_ += (markdown_ ? markdown_escaped(sentence) : wrapped_with_indent(sentence, line_columns, 0)) + "\n";
    in_facts_ = false;
  }
  void drawing(const std::string& lines) override {
    part(true);
    text_ += markdown_ ? "```text\n" + lines + "```\n" : lines;
    in_facts_ = false;
  }
  std::string text() override { return std::move(text_); }

 private:
  void part(bool blank) {
    if (blank) text_ += "\n";
  }
  static std::string seen(const Cell& c, const std::string& digits) {
    if (!c.words.empty() || c.value.is_null() || c.value.is_discarded()) return c.words;
    if (c.value.is_string()) return c.value.get<std::string>();
    return c.value.is_number_float() ? fmt::format(fmt::runtime(digits), c.value.get<double>()) : c.value.dump();
  }

  static constexpr std::size_t heading_columns = 12;  // of facts, and what their further lines are indented by
  bool markdown_, in_facts_ = false;
  std::string text_;
};

}  // namespace

std::string Writer::key_in(std::string_view key, FrequencyUnit unit) const {
  if (for_json() || unit == FrequencyUnit::radians) return std::string(key);
  return fmt::format("{}_{}", key, unit == FrequencyUnit::hertz ? "hz" : "rpm");
}

std::string Writer::frequency_heading(std::string_view what) const {
  const std::string_view symbol = !what.empty() ? what : in_radians() ? "ω" : "f";
  return fmt::format("{} [{}]", symbol, frequency_unit());
}

std::string Writer::spin_heading() const { return fmt::format("{} [{}]", spins_in_radians() ? "Ω" : "speed", spin_unit()); }

std::unique_ptr<Writer> writer(std::string_view kind, const Model& model, const Timings& timings, const Layout& layout, int version) {
  if (layout.format == Format::json || layout.format == Format::html)
    return std::make_unique<JsonWriter>(kind, model, timings, layout, version);
  if (layout.format == Format::csv) return std::make_unique<CsvWriter>(layout);
  return std::make_unique<TextWriter>(model, layout);
}

}  // namespace gyromode::io
