#include "gyromode/write/json_parts.h"
#include "gyromode/write/result_json.h"
#include "gyromode/structure/symmetry_words.h"

namespace gyromode::io {

namespace {

Json finding(const Model& model, const SymmetryFinding& f) {
  Json one{{"labels", labels_of(model.labels(), f.coordinates)}, {"found", f.reflection.has_value()}, {"breach", number(f.departure)}, {"threshold", f.threshold}, {"amplification", f.amplification}};
  if (f.reflection) {
    one["in_words"] = in_words(*f.reflection, chosen(model.labels(), f.coordinates));
    one["reflection"] = rows_of(*f.reflection);
  }
  return one;
}

Json value_of(double x) { return x; }
Json value_of(const Matrix& a) { return rows_of(a); }
Json value_of(const std::vector<std::pair<std::string, double>>& numbers) {
  Json j;
  for (const auto& [name, x] : numbers) j[name] = x;
  return j;
}

}  // namespace

std::string structure_json(const Model& model, const StructureReport& r, const Timings& timings) {
  Json j = head("gyromode/structure/1", model, timings);
  j["structure"] = structure_facts(model, r.structure, r.stiffness, r.stiffness_applies);
  j["components"] = Json::array();
  for (const Component& c : r.structure.components) j["components"].push_back(labels_of(model.labels(), c.coordinates));
  if (const auto witness = r.structure.witness()) {
    j["witness"] = labels_of(model.labels(), witness->coordinates);
    Json kinds = Json::array();
    for (const CouplingKind k : witness->kinds) kinds.push_back(k == CouplingKind::cross ? "G" : "M or K");
    j["witness_couplings"] = std::move(kinds);
  }
  for (const SymmetryFinding& f : r.symmetries) j["reversing_symmetry"].push_back(finding(model, f));
  Json checks;
  for (const ModelCheck& c : r.checks) checks[c.name] = std::visit([](const auto& x) { return value_of(x); }, c.value);
  checks["coupling_tolerance"] = model.ignored ? model.ignored->tolerance : 0;
  j["checks"] = std::move(checks);
  if (!r.clamped_booms.empty()) {
    j["held_booms"] = Json::array();
    for (const ClampedBoom& h : r.clamped_booms) j["held_booms"].push_back({{"name", h.name}, {"omega", h.frequencies}});
  }
  if (!r.effective_axes.empty()) {
    j["effective_axes"] = Json::array();
    for (const EffectiveAxes& e : r.effective_axes) j["effective_axes"].push_back({{"omega", e.omega}, {"psi", e.angle}});
  }
  if (r.at) {
    const Realified& at = r.at->realified;
    j["at"] = {{"omega", r.at->omega}, {"H", complex_rows(at.impedance)}, {"transformation", complex_rows(at.unitary)}, {"H_star", rows_of(at.real_symmetric)},
               {"by", to_string(at.how)}, {"negative", at.negative()}, {"determinant_sign", at.determinant_sign()}};
    if (at.angle) j["at"]["psi"] = *at.angle;
  }
  return text(j);
}

}  // namespace gyromode::io
