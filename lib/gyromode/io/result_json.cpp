#include "gyromode/io/result_json.h"

#include "gyromode/lapack/library.h"
#include "gyromode/version.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

using Json = nlohmann::ordered_json;

Json number(double x) { return std::isfinite(x) ? Json(x) : Json(nullptr); }
Json bounds(const Window& w) { return Json::array({number(w.a), number(w.b)}); }

Json labels_of(const Labels& labels, const std::vector<Index>& coordinates) {
  Json all = Json::array();
  for (const Index i : coordinates) all.push_back(labels[static_cast<std::size_t>(i)]);
  return all;
}

Json rows_of(const Matrix& a) {
  Json rows = Json::array();
  for (Index i = 0; i < a.rows(); ++i) {
    Json row = Json::array();
    for (Index j = 0; j < a.cols(); ++j) row.push_back(a(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json complex_rows(const ComplexMatrix& a) { return {{"re", rows_of(a.real())}, {"im", rows_of(a.imag())}}; }

std::string_view word(Sign sign) {
  switch (sign) {
    case Sign::positive: return "positive";
    case Sign::semidefinite: return "semidefinite";
    default: return "indefinite";
  }
}

// What every document starts with.
Json head(std::string_view schema, const Model& model, const Timings& timings) {
  Json j;
  j["schema"] = schema;
  j["model"] = {{"title", model.title}, {"sha256", model.sha256}, {"coordinates", model.size()}, {"kind", model.kind}, {"frame", "turning"}};
  j["versions"] = {{"gyromode", version()}, {"blas", lapack::library()}};
  j["timings"] = {{"read_s", timings.read}, {"solve_s", timings.solve}};
  return j;
}

Json structure_facts(const Model& model, const Structure& s, const Stiffness& k, bool has_stiffness) {
  const bool quadrature = s.system_class() == SystemClass::quadrature;
  Json j;
  j["class"] = std::holds_alternative<Spacecraft>(model.system) ? "transcendental" : quadrature ? "quadrature" : "general";
  j["in_phase"] = quadrature ? labels_of(model.labels(), s.in_phase()) : Json::array();
  j["quadrature"] = quadrature ? labels_of(model.labels(), s.in_quadrature()) : Json::array();
  if (has_stiffness) {
    j["stiffness"] = word(k.sign);
    j["negative"] = k.negative;
    j["zero"] = k.zero;
  }
  if (s.largest_ignored_coupling > 0) j["largest_ignored_coupling"] = s.largest_ignored_coupling;
  return j;
}

Json balance_json(const IndexBalance& b) {
  return {{"negative", b.negative}, {"real_pairs", b.real_pairs}, {"quadruples", b.quadruples}, {"negative_energy", b.negative_energy},
          {"zero", b.zero}, {"zero_negative", b.zero_negative}, {"closed", b.closed}};
}

Json mode_json(const Model& model, const Mode& m) {
  Json j;
  j["omega"] = m.omega;
  j["frequency_hz"] = m.omega / (2 * std::numbers::pi);
  j["energy_sign"] = m.energy_sign;
  j["kind"] = gyromode::word(m.kind);
  j["multiplicity"] = m.multiplicity;
  j["residual"] = number(m.residual);
  j["error_bound"] = number(m.error_bound);
  if (m.bracket) j["bracket"] = *m.bracket;
  if (m.shape.size() > 0) {
    const Vector re = m.shape.real();
    const Vector im = m.shape.imag();
    j["shape"] = {{"labels", model.labels()}, {"re", std::vector<double>(re.begin(), re.end())}, {"im", std::vector<double>(im.begin(), im.end())}};
  }
  if (!m.field.empty()) {
    // In the order of the points of "geometry".
    Json re = Json::array(), im = Json::array();
    for (const ComplexMatrix& line : m.field) {
      for (Index k = 0; k < line.cols(); ++k) {
        re.push_back({line(0, k).real(), line(1, k).real(), line(2, k).real()});
        im.push_back({line(0, k).imag(), line(1, k).imag(), line(2, k).imag()});
      }
    }
    j["displacements"] = {{"re", std::move(re)}, {"im", std::move(im)}};
  }
  return j;
}

Json modes_array(const Model& model, const std::vector<Mode>& modes) {
  Json all = Json::array();
  for (const Mode& m : modes) all.push_back(mode_json(model, m));
  return all;
}

Json unstable_array(const std::vector<UnstableMode>& modes) {
  Json all = Json::array();
  for (const UnstableMode& u : modes) all.push_back({{"growth_rate", u.growth_rate}, {"omega", u.omega}, {"kind", u.flutter() ? "flutter" : "divergence"}});
  return all;
}

// Points at rest, and the lines through them. Where each mode takes them stands with the mode.
Json geometry(const ModesResult& r) {
  if (r.outlines.empty()) return nullptr;
  Json points = Json::array(), lines = Json::array();
  for (const ModelOutline& o : r.outlines) {
    Json through = Json::array();
    for (const Eigen::Vector3d& p : o.points) {
      through.push_back(points.size());
      points.push_back({p(0), p(1), p(2)});
    }
    lines.push_back({{"name", o.name}, {"points", std::move(through)}});
  }
  return {{"points", std::move(points)}, {"lines", std::move(lines)}, {"displacements", "modes[].displacements"}};
}

std::string text(const Json& j) { return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

std::string modes_json(const Model& model, const ModesResult& r, const Timings& timings) {
  Json j = head("gyromode/modes/1", model, timings);
  j["structure"] = structure_facts(model, r.structure, r.stiffness, !r.first_order);
  j["structure"]["path"] = r.path;
  j["stability"] = gyromode::word(r.stability);
  j["index_balance"] = balance_json(r.index_balance);
  const Coverage& c = r.coverage;
  j["coverage"] = {{"status", gyromode::word(c.status)}, {"window", bounds(c.window)}, {"requested", bounds(c.requested)}, {"found", c.found},
                   {"counted", c.counted ? Json(*c.counted) : Json(nullptr)}};
  if (!c.reason.empty()) j["coverage"]["reason"] = c.reason;
  j["modes"] = modes_array(model, r.modes);
  j["unstable"] = unstable_array(r.unstable);
  j["geometry"] = geometry(r);  // a matrix model has none
  return text(j);
}

std::string count_json(const Model& model, const CountResult& r, const Timings& timings) {
  Json j = head("gyromode/count/1", model, timings);
  j["window"] = bounds(r.window);
  j["requested"] = bounds(r.requested);
  j["count"] = r.count ? Json(*r.count) : Json(nullptr);
  j["signed"] = r.signed_count;
  j["zero"] = r.zero;
  j["negative"] = r.negative;
  j["status"] = gyromode::word(r.status);
  return text(j);
}

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
  checks["coupling_tolerance"] = r.coupling_tolerance;
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
    j["at"] = {{"omega", r.at->omega}, {"H", complex_rows(r.at->impedance)}, {"transformation", complex_rows(r.at->unitary)}, {"H_star", rows_of(r.at->real_symmetric)}};
  }
  return text(j);
}

std::string stability_json(const Model& model, const ModesResult& r, const Timings& timings) {
  Json j = head("gyromode/stability/1", model, timings);
  j["stability"] = gyromode::word(r.stability);
  j["index_balance"] = balance_json(r.index_balance);
  j["unstable"] = unstable_array(r.unstable);
  j["negative_modes"] = modes_array(model, r.negative_modes);
  j["margin"] = {{"opposite_sign_gap", number(r.opposite_gap)}};
  return text(j);
}

}  // namespace gyromode::io
