#include "gyromode/write/result_text.h"

#include "gyromode/write/text_parts.h"

#include <fmt/format.h>

namespace gyromode::io {

namespace {

std::string coverage_words(const Coverage& c) {
  std::string out = fmt::format("{}: found {}", to_string(c.status), c.found);
  if (c.counted) out += fmt::format(", counted {}", *c.counted);
  out += fmt::format(" in {} rad/s", window_words(c.window));
  return c.reason.empty() ? out : out + " — " + c.reason;
}

std::string shape_table(const Model& model, const std::vector<Mode>& modes, Format format) {
  constexpr Index most_columns = 12;
  const Index shown = std::min<Index>(model.size(), most_columns);
  std::vector<std::string> head{"#"};
  for (Index i = 0; i < shown; ++i) head.push_back(model.labels()[static_cast<std::size_t>(i)]);
  Grid grid(head);
  for (std::size_t k = 0; k < modes.size(); ++k) {
    std::vector<std::string> row{fmt::format("{}", k + 1)};
    for (Index i = 0; i < shown; ++i) row.push_back(complex_cell(modes[k].shape(i)));
    grid.add(std::move(row));
  }
  const std::string rest = shown < model.size() ? fmt::format("(the first {} of {} coordinates; all of them with --format json or csv)\n", shown, model.size()) : "";
  return written(grid, format) + rest;
}

}  // namespace

std::string modes_text(const Model& model, const ModesResult& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "class", class_words(model, r.structure) + (r.first_order ? "" : "; " + stiffness_words(r.stiffness)));
  if (model.ignored) out += fact(format, "left out", in_words(*model.ignored));
  out += fact(format, "solver", r.solver);
  out += fact(format, "stability", stability_words(r.stability));
  out += fact(format, "coverage", coverage_words(r.coverage));
  out += "\n";
  if (!r.modes.empty()) out += frequency_table(r.modes, format);
  if (!r.modes.empty() && r.modes.front().shape.size() > 0) out += "\n" + shape_table(model, r.modes, format);
  if (!r.unstable.empty()) out += "\n" + unstable_table(r.unstable, format);
  return out;
}

std::string count_text(const Model& model, const CountResult& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "window", window_words(r.window) + " rad/s");
  out += fact(format, "modes", r.count ? fmt::format("{}{}", *r.count, r.zero > 0 ? fmt::format(", {} of them at zero", r.zero) : "") : "not known");
  out += fact(format, "signed", fmt::format("{} (n₋(H) = {} at the lower end, {} at the upper)", r.signed_count, r.negative[0], r.negative[1]));
  out += fact(format, "status", std::string(to_string(r.status)));
  return out;
}

}  // namespace gyromode::io
