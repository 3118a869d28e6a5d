#include "gyromode/formats/csv.h"
#include "gyromode/write/json_parts.h"
#include "gyromode/write/text_parts.h"

#include <fmt/format.h>

#include <complex>
#include <iterator>

namespace gyromode::io {

namespace {

std::vector<double> numbers(const Vector& v) { return {v.begin(), v.end()}; }

std::string history_csv(const ResponseReport& r) {
  std::string out = "t";
  for (const std::string& label : r.labels) out += "," + csv_field(label);
  if (r.rates) {
    for (const std::string& label : r.labels) out += "," + csv_field(label + " rate");
  }
  out += "\n";
  auto to = std::back_inserter(out);
  for (Index k = 0; k < r.history.t.size(); ++k) {
    fmt::format_to(to, "{}", r.history.t(k));
    for (const double q : r.history.q.col(k)) fmt::format_to(to, ",{}", q);
    if (r.rates) {
      for (const double v : r.history.qdot.col(k)) fmt::format_to(to, ",{}", v);
    }
    out += '\n';
  }
  return out;
}

std::string response_json(const Model& model, const ResponseReport& r, const Timings& timings) {
  Json j = head("gyromode/response/1", model, timings);
  j["stability"] = to_string(r.stability);
  j["labels"] = r.labels;
  j["t"] = numbers(r.history.t);
  j["q"] = rows_of(r.history.q.transpose());
  if (r.rates) j["qdot"] = rows_of(r.history.qdot.transpose());
  j["modal"] = Json::array();
  for (const ModalShare& m : r.modal) {
    const Vector re = m.shape.real(), im = m.shape.imag();
    j["modal"].push_back({{"omega", m.omega}, {"amplitude", m.amplitude}, {"phase", m.phase}, {"energy", m.energy}, {"energy_sign", m.energy_sign},
                          {"shape", {{"labels", r.labels}, {"re", numbers(re)}, {"im", numbers(im)}}}});
  }
  j["energy"] = {{"initial", r.initial_energy}, {"zero_roots", r.zero_energy}, {"growing_or_double_roots", r.remainder_energy}};
  j["departure"] = r.departure;
  j["phase_error"] = r.phase_error;
  j["balance_closed"] = r.balance_closed;
  if (!r.remark.empty()) j["remark"] = r.remark;
  if (r.history.interrupted) j["interrupted"] = true;
  return text(j);
}

std::string response_text(const Model& model, const ResponseReport& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "stability", stability_words(r.stability));
  out += fact(format, "energy", fmt::format("{:.10g} at first; {:.6g} in zero roots, {:.6g} in growing motion and double roots, the rest in modes", r.initial_energy, r.zero_energy, r.remainder_energy));
  out += fact(format, "accuracy", fmt::format("{:.1e} of the motion at first; phases at the last time to {:.1e} rad", r.departure, r.phase_error));
  if (!r.remark.empty()) out += fact(format, "remark", r.remark);
  Grid shares({"ω [rad/s]", "amplitude", "phase [rad]", "energy", "largest in"});
  for (const ModalShare& m : r.modal) {
    Index at = 0;
    if (m.shape.size() > 0) m.shape.cwiseAbs().maxCoeff(&at);
    shares.add({fmt::format("{:.15g}", m.omega), fmt::format("{:.6g}", m.amplitude), fmt::format("{:.6g}", m.phase), fmt::format("{:.6g}", m.energy), r.labels[static_cast<std::size_t>(at)]});
  }
  if (!shares.empty()) out += "\n" + written(shares, format);
  constexpr Index most_columns = 8;
  const Index shown = std::min<Index>(static_cast<Index>(r.labels.size()), most_columns);
  std::vector<std::string> head{"t [s]"};
  for (Index i = 0; i < shown; ++i) head.push_back(r.labels[static_cast<std::size_t>(i)]);
  Grid grid(head);
  for (Index k = 0; k < r.history.t.size(); ++k) {
    std::vector<std::string> row{fmt::format("{:g}", r.history.t(k))};
    for (Index i = 0; i < shown; ++i) row.push_back(fmt::format("{:.8g}", r.history.q(i, k)));
    grid.add(std::move(row));
  }
  return out + "\n" + written(grid, format);
}

std::string frequency_csv(const FrequencyReport& r) {
  std::string out = "omega,resonance,added";
  for (const std::string& label : r.labels) out += fmt::format(",{},{}", csv_field(label + " re"), csv_field(label + " im"));
  out += ",driven,participation\n";
  for (const FrequencyPoint& p : r.response.points) {
    out += fmt::format("{},{},{}", p.omega, p.resonance() ? 1 : 0, p.added ? 1 : 0);
    for (std::size_t i = 0; i < r.labels.size(); ++i) {
      if (p.resonance()) out += ",inf,";
      else out += fmt::format(",{},{}", p.q(static_cast<Index>(i)).real(), p.q(static_cast<Index>(i)).imag());
    }
    const bool on = p.participation && !p.added;  // a mode
    out += fmt::format(",{},{}\n", on ? to_string(p.driven) : "", p.participation ? fmt::format("{}", *p.participation) : "");
  }
  return out;
}

std::string frequency_json(const Model& model, const FrequencyReport& r, const Timings& timings) {
  Json j = head("gyromode/frequency_response/1", model, timings);
  if (r.response.interrupted) j["interrupted"] = true;
  j["labels"] = r.labels;
  j["resonances"] = r.response.resonances();
  j["modes"] = Json::array();
  for (const DrivenMode& m : r.response.modes) {
    j["modes"].push_back({{"omega", m.omega}, {"error_bound", m.error}, {"driven", to_string(m.driven)}, {"participation", m.participation}, {"resolution", m.resolution}});
  }
  j["points"] = Json::array();
  for (const FrequencyPoint& p : r.response.points) {
    Json one{{"omega", p.omega}, {"resonance", p.resonance()}, {"added", p.added}};
    if (p.participation && !p.added) one["driven"] = to_string(p.driven);
    if (p.participation) one["participation"] = *p.participation;
    const Vector re = p.q.real(), im = p.q.imag();
    one["re"] = p.resonance() ? Json(nullptr) : Json(numbers(re));
    one["im"] = p.resonance() ? Json(nullptr) : Json(numbers(im));
    j["points"].push_back(std::move(one));
  }
  return text(j);
}

std::string note(const FrequencyPoint& p) {
  if (p.added) return "beside a resonance";
  if (!p.participation) return "";
  switch (p.driven) {
    case Driven::yes: return fmt::format("resonance, participation {:.2g}", *p.participation);
    case Driven::undecided: return fmt::format("limit at a mode: whether it is driven cannot be told, participation {:.1g}", *p.participation);
    default: return "limit at a mode that is not driven";
  }
}

std::string frequency_text(const Model& model, const FrequencyReport& r, Format format) {
  std::string out = heading(format, model_line(model));
  constexpr Index most_columns = 6;
  const Index shown = std::min<Index>(static_cast<Index>(r.labels.size()), most_columns);
  std::vector<std::string> head{"ω [rad/s]"};
  for (Index i = 0; i < shown; ++i) head.push_back("|" + r.labels[static_cast<std::size_t>(i)] + "|");
  head.push_back("");
  Grid grid(head);
  for (const FrequencyPoint& p : r.response.points) {
    std::vector<std::string> row{fmt::format("{:.10g}", p.omega)};
    for (Index i = 0; i < shown; ++i) row.push_back(p.resonance() ? "∞" : fmt::format("{:.6g}", std::abs(p.q(i))));
    row.push_back(note(p));
    grid.add(std::move(row));
  }
  return out + written(grid, format);
}

}  // namespace

std::string document(const Model& model, const ResponseReport& report, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return response_json(model, report, timings);
    case Format::csv: return history_csv(report);
    default: return response_text(model, report, format);
  }
}

std::string document(const Model& model, const FrequencyReport& report, const Timings& timings, Format format) {
  switch (format) {
    case Format::json: return frequency_json(model, report, timings);
    case Format::csv: return frequency_csv(report);
    default: return frequency_text(model, report, format);
  }
}

}  // namespace gyromode::io
