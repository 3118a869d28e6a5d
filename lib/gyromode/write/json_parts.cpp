#include "gyromode/write/json_parts.h"

#include "gyromode/lapack/library.h"
#include "gyromode/version.h"

#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

Json shape_json(const Model& model, const ComplexVector& shape) {
  const Vector re = shape.real();
  const Vector im = shape.imag();
  return {{"labels", model.labels()}, {"re", std::vector<double>(re.begin(), re.end())}, {"im", std::vector<double>(im.begin(), im.end())}};
}

Json mode_json(const Model& model, const Mode& m) {
  Json j;
  j["omega"] = m.omega;
  j["frequency_hz"] = m.omega / (2 * std::numbers::pi);
  j["energy_sign"] = m.energy_sign;
  j["kind"] = gyromode::to_string(m.kind);
  j["multiplicity"] = m.multiplicity;
  j["residual"] = number(m.residual);
  j["error_bound"] = number(m.error_bound);
  if (m.cluster > 1) j["cluster"] = m.cluster;
  if (m.bracket) j["bracket"] = *m.bracket;
  if (m.shape.size() > 0) j["shape"] = shape_json(model, m.shape);
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

}  // namespace

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

Json head(std::string_view schema, const Model& model, const Timings& timings) {
  Json j;
  j["schema"] = schema;
  j["model"] = {{"title", model.title}, {"sha256", model.sha256}, {"coordinates", model.size()}, {"kind", model.kind}, {"frame", "turning"}};
  if (model.ignored) j["model"]["couplings_left_out"] = {{"up_to", model.ignored->tolerance}, {"largest", model.ignored->largest}};
  j["versions"] = {{"gyromode", version()}, {"blas", lapack::library()}};
  j["timings"] = {{"read_s", timings.read}, {"solve_s", timings.solve}};
  return j;
}

Json structure_facts(const Model& model, const Structure& s, const InertiaOfK& k, bool has_stiffness) {
  const bool quadrature = s.system_class() == SystemClass::quadrature;
  Json j;
  j["class"] = model.body->transcendental() ? "transcendental" : to_string(s.system_class());
  j["in_phase"] = quadrature ? labels_of(model.labels(), s.in_phase()) : Json::array();
  j["quadrature"] = quadrature ? labels_of(model.labels(), s.in_quadrature()) : Json::array();
  if (has_stiffness) {
    j["stiffness"] = to_string(k.definiteness());
    j["negative"] = k.negative;
    j["zero"] = k.zero;
  }
  if (model.ignored && model.ignored->largest > 0) j["largest_ignored_coupling"] = model.ignored->largest;
  return j;
}

Json balance_json(const IndexBalance& b) {
  return {{"negative", b.negative}, {"real_pairs", b.real_pairs}, {"quadruples", b.quadruples}, {"negative_energy", b.negative_energy},
          {"zero", b.zero}, {"zero_negative", b.zero_negative}, {"closed", b.closed}};
}

Json modes_array(const Model& model, const std::vector<Mode>& modes) {
  Json all = Json::array();
  for (const Mode& m : modes) all.push_back(mode_json(model, m));
  return all;
}

Json unstable_array(const Model& model, const std::vector<UnstableMode>& modes) {
  Json all = Json::array();
  for (const UnstableMode& u : modes) {
    Json j{{"growth_rate", u.growth_rate}, {"omega", u.omega}, {"kind", u.flutter() ? "flutter" : "divergence"}, {"residual", number(u.residual)}, {"error_bound", number(u.error_bound)}};
    if (u.shape.size() > 0) j["shape"] = shape_json(model, u.shape);
    all.push_back(std::move(j));
  }
  return all;
}

std::string text(const Json& j) { return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace gyromode::io
