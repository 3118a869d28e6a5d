#include "gyromode/io/json_parts.h"
#include "gyromode/io/result_json.h"
#include "gyromode/structure/symmetry_words.h"

namespace gyromode::io {

namespace {

// Of every component in which one was looked for, what was found or how far the nearest is from being one.
void add_reversing_symmetries(const Model& model, const Structure& s, Json& j) {
  const auto* system = std::get_if<System>(&model.system);
  for (const Component& c : s.components) {
    if (!c.search || !system) continue;
    Json one{{"labels", labels_of(model.labels(), c.coordinates)}, {"found", c.search->found.has_value()}, {"breach", number(c.search->breach)},
             {"threshold", c.search->threshold}, {"amplification", c.search->amplification}};
    if (c.search->found) {
      const Matrix reflection = c.search->found->reflection(system->mass()(c.coordinates, c.coordinates));
      one["in_words"] = in_words(reflection, chosen(model.labels(), c.coordinates));
      one["reflection"] = rows_of(reflection);
    }
    j["reversing_symmetry"].push_back(std::move(one));
  }
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
  add_reversing_symmetries(model, r.structure, j);
  Json checks;
  if (const auto* s = std::get_if<System>(&model.system)) {
    const auto& e = s->symmetry_errors();
    checks["symmetry_errors"] = {{"mass", e.mass}, {"gyroscopic", e.gyroscopic}, {"stiffness", e.stiffness}};
    checks["scales"] = {{"mass", s->mass().cwiseAbs().maxCoeff()}, {"gyroscopic", s->gyroscopic().cwiseAbs().maxCoeff()}, {"stiffness", s->stiffness().cwiseAbs().maxCoeff()}};
    checks["mass_trace"] = s->mass().trace();
  } else if (const auto* craft = std::get_if<Spacecraft>(&model.system)) {
    checks["mass"] = craft->rigid().mass;
    checks["centre_height"] = craft->centre();
    checks["inertia"] = rows_of(craft->rigid().inertia());
  } else {
    const auto& f = std::get<FirstOrderSystem>(model.system);
    checks["symmetry_errors"] = {{"inertia", f.symmetry_errors().inertia}, {"gyroscopic", f.symmetry_errors().gyroscopic}};
    checks["scales"] = {{"inertia", f.inertia().cwiseAbs().maxCoeff()}, {"gyroscopic", f.gyroscopic().cwiseAbs().maxCoeff()}};
  }
  checks["coupling_tolerance"] = model.ignored ? model.ignored->tolerance : 0;
  j["checks"] = std::move(checks);
  if (!r.held_booms.empty()) {
    j["held_booms"] = Json::array();
    for (const HeldBoom& h : r.held_booms) j["held_booms"].push_back({{"name", h.name}, {"omega", h.frequencies}});
  }
  if (!r.effective_axes.empty()) {
    j["effective_axes"] = Json::array();
    for (const EffectiveAxes& e : r.effective_axes) j["effective_axes"].push_back({{"omega", e.omega}, {"psi", e.angle}});
  }
  if (r.at) {
    const Realified& at = r.at->realified;
    j["at"] = {{"omega", r.at->omega}, {"H", complex_rows(at.impedance)}, {"transformation", complex_rows(at.unitary)}, {"H_star", rows_of(at.real_symmetric)},
               {"by", word(at.how)}, {"negative", at.negative()}, {"determinant_sign", at.determinant_sign()}};
    if (at.angle) j["at"]["psi"] = *at.angle;
  }
  return text(j);
}

}  // namespace gyromode::io
