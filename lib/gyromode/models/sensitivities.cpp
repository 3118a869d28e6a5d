#include "gyromode/models/sensitivities.h"

#include "gyromode/base/error.h"
#include "gyromode/models/model_kind.h"
#include "gyromode/models/parameter_keys.h"
#include "gyromode/sensitivity/parameter_slope.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <memory>

namespace gyromode {

namespace {

constexpr Complex j(0, 1);
const double unknown = std::nan("");
const char* const none_around = "the coordinates change with it, or no model is lawful on both sides";

// ∂H/∂p X at fixed ω, with what is open of the matrix entry by entry; and −∂H/∂ω X.
struct Derivatives {
  ComplexMatrix by_parameter, form;
  Matrix error, error_of_form = {};  // of the form: empty where it is known
};

// What a kind of model says of H at a root.
class Impedances {
 public:
  virtual ~Impedances() = default;
  /// Prepares the derivative by one parameter; false where there is none.
  virtual bool choose(const MatricesAt& at, double value) = 0;
  /// The matrices of the model with other values of its parameters.
  virtual ParameterMatrices with(const ModelKind& model, const std::vector<ParameterValue>& values) const = 0;
  virtual std::optional<Derivatives> at(double omega, const ComplexMatrix& x) = 0;
};

ComplexMatrix times(const Matrix& a, const ComplexMatrix& x) { return (a * x.real()).cast<Complex>() + j * (a * x.imag()).cast<Complex>(); }

// H = K + jωG − ω²M; of first order ωI − jG.
class OfMatrices : public Impedances {
 public:
  explicit OfMatrices(const ModelKind& model) {
    for (const ModelKind::NamedMatrix& m : model.matrices()) own_.all.push_back(*m.matrix);
    const System* system = model.second_order();
    if (!system || system->size() == model.size()) return;
    for (const std::string& label : system->labels()) {  // of a condensed model those with mass
      const auto found = std::find(model.labels().begin(), model.labels().end(), label);
      kept_.push_back(static_cast<Index>(found - model.labels().begin()));
    }
  }
  ParameterMatrices with(const ModelKind& model, const std::vector<ParameterValue>& values) const override {
    return {model.matrices_with(values)};
  }
  bool choose(const MatricesAt& at, double value) override {
    auto found = parameter_slopes(at, value);
    if (found) slopes_ = std::move(*found);
    return found.has_value();
  }
  std::optional<Derivatives> at(double w, const ComplexMatrix& shapes) override {
    const ComplexMatrix x = kept_.empty() ? shapes : ComplexMatrix(shapes(kept_, Eigen::all));
    const auto& a = own_.all;
    if (a.size() == 2)
      return Derivatives{w * times(slopes_[0].value, x) - j * times(slopes_[1].value, x), -times(a[0], x),
                         w * slopes_[0].error + slopes_[1].error};
    return Derivatives{times(slopes_[2].value, x) + (j * w) * times(slopes_[1].value, x) - w * w * times(slopes_[0].value, x),
                       2 * w * times(a[0], x) - j * times(a[1], x), slopes_[2].error + w * slopes_[1].error + w * w * slopes_[0].error};
  }
  const std::vector<Index>& kept() const { return kept_; }

 private:
  ParameterMatrices own_;
  std::vector<Index> kept_;
  std::vector<MatrixSlope> slopes_;
};

// Exact booms: H as a function, its derivatives by differences at every root.
class OfFunction : public Impedances {
 public:
  explicit OfFunction(const ModelKind& model) : model_(model) {}
  ParameterMatrices with(const ModelKind& model, const std::vector<ParameterValue>& values) const override {
    const auto changed = model.with(values);
    const ComplexMatrix h = changed->spin_source().impedance(omega_, require_parameter(*changed, "spin").value);
    return {{h.real(), h.imag()}};
  }
  bool choose(const MatricesAt& at, double value) override {
    at_ = at;
    value_ = value;
    return true;
  }
  std::optional<Derivatives> at(double w, const ComplexMatrix& x) override {
    if (!(x.cwiseAbs().maxCoeff() > 0)) return std::nullopt;  // booms alone: the body says nothing
    omega_ = w;
    const auto by_parameter = parameter_slopes(at_, value_);
    const auto by_omega = parameter_slopes(
        [&](double omega) {
          const ComplexMatrix h = model_.spin_source().impedance(omega, require_parameter(model_, "spin").value);
          return ParameterMatrices{{h.real(), h.imag()}};
        },
        w);
    if (!by_parameter || !by_omega) return std::nullopt;
    const Matrix open_form = (*by_omega)[0].error + (*by_omega)[1].error;
    const auto product = [&](const std::vector<MatrixSlope>& s) { return ComplexMatrix(times(s[0].value, x) + j * times(s[1].value, x)); };
    return Derivatives{product(*by_parameter), -product(*by_omega), (*by_parameter)[0].error + (*by_parameter)[1].error, open_form};
  }

 private:
  const ModelKind& model_;
  MatricesAt at_;
  double value_ = 0, omega_ = 1;
};

// A large model whose only number is its spin.
class OfSpin : public Impedances {
 public:
  explicit OfSpin(const ModelKind& model) : model_(model) {}
  ParameterMatrices with(const ModelKind&, const std::vector<ParameterValue>&) const override { return {}; }
  bool choose(const MatricesAt&, double) override { return true; }
  std::optional<Derivatives> at(double w, const ComplexMatrix& x) override {
    auto slopes = model_.spin_slopes(w, x);
    if (!slopes) return std::nullopt;
    return Derivatives{std::move(slopes->by_spin), std::move(slopes->form), {}};
  }

 private:
  const ModelKind& model_;
};

std::unique_ptr<Impedances> impedances_of(const ModelKind& model) {
  if (!model.matrices().empty()) return std::make_unique<OfMatrices>(model);
  if (model.transcendental()) return std::make_unique<OfFunction>(model);
  if (model.parameter("spin")) return std::make_unique<OfSpin>(model);
  throw NotApplicable(fmt::format("sensitivities need a model of matrices, a rotor or a spacecraft; this one is: {}", model.in_words()));
}

// What is open of the form of shapes, relative to it.
double open_part(const ComplexMatrix& x, const Derivatives& d) {
  if (d.error_of_form.size() == 0) return 0;
  const Matrix size = x.cwiseAbs();
  return (size.transpose() * d.error_of_form * size).norm() / std::abs((x.adjoint() * d.form).trace());
}

// "cable[2].length" as "cable[*].length".
std::string of_all(const std::string& key) {
  const std::size_t open = key.find('['), close = key.find(']', open);
  return close == std::string::npos ? key : key.substr(0, open) + "[*]" + key.substr(close + 1);
}

// Whether all that a pattern names have one value, so that they may change together.
bool have_one_value(const std::vector<Parameter>& all, const std::string& pattern, double value) {
  return std::all_of(all.begin(), all.end(), [&](const Parameter& p) { return !names(pattern, p.key) || p.value == value; });
}

// Whether "outer_diameter[0]" is listed beside "outer_diameter" for both, or "inertia[1][1]" beside "inertia[1]".
bool is_part_of_another(const std::vector<Parameter>& all, const std::string& key) {
  if (!key.ends_with(']')) return false;
  const std::string whole = key.substr(0, key.rfind('['));
  return std::any_of(all.begin(), all.end(), [&](const Parameter& p) { return p.key == whole; }) &&
         (!whole.ends_with(']') || key == whole + whole.substr(whole.rfind('[')));
}

// A key with [*] is one parameter where all that it names have one value, else each of them. Of a spacecraft, which has
// no equilibrium where one boom of several changes, equal parts change together unless their keys are given.
std::vector<Parameter> parameters_of(const ModelKind& model, const std::vector<std::string>& keys) {
  std::vector<Parameter> listed = model.named_parameters(), chosen;
  if (listed.empty() || !keys.empty()) listed = model.parameters();
  if (keys.empty()) {
    for (Parameter p : listed) {
      if (is_part_of_another(listed, p.key)) continue;
      const std::string pattern = of_all(p.key);
      if (model.transcendental() && !p.key.starts_with("body") && have_one_value(listed, pattern, p.value)) p.key = pattern;
      if (std::none_of(chosen.begin(), chosen.end(), [&](const Parameter& c) { return c.key == p.key; })) chosen.push_back(p);
    }
    return chosen;
  }
  for (const std::string& key : keys) {
    const Parameter first = require_parameter(model, key);
    if (have_one_value(listed, key, first.value)) {
      chosen.push_back({key, first.dimension, first.value});
      continue;
    }
    std::copy_if(listed.begin(), listed.end(), std::back_inserter(chosen), [&](const Parameter& p) { return names(key, p.key); });
  }
  return chosen;
}

// Ranges of roots that coincide within their errors.
std::vector<std::pair<std::size_t, std::size_t>> clusters_of(const std::vector<double>& omega, const std::vector<double>& error) {
  std::vector<std::pair<std::size_t, std::size_t>> all;
  for (std::size_t first = 0, past; first < omega.size(); first = past) {
    past = first + 1;
    while (past < omega.size() && omega[past] - omega[past - 1] <= 4 * (error[past] + error[past - 1])) ++past;
    all.emplace_back(first, past);
  }
  return all;
}

}  // namespace

std::vector<Sensitivity> sensitivities(const ModelKind& model, const std::vector<Mode>& modes, const std::vector<std::string>& keys) {
  std::vector<double> omega, bound;
  for (const Mode& m : modes) {
    if (m.shape.size() == 0) throw InvalidArgument("sensitivities need modes with their shapes");
    omega.push_back(m.omega);
    bound.push_back(m.error_bound);
  }
  const auto clusters = clusters_of(omega, bound);
  const std::unique_ptr<Impedances> impedances = impedances_of(model);
  std::vector<Sensitivity> all;
  for (const Parameter& p : parameters_of(model, keys)) {
    Sensitivity s{p, std::vector<double>(modes.size(), unknown), std::vector<double>(modes.size(), unknown), ""};
    const MatricesAt at = [&](double value) { return impedances->with(model, {{p.key, value}}); };
    if (!impedances->choose(at, p.value)) {
      s.reason = none_around;
      all.push_back(std::move(s));
      continue;
    }
    for (const auto& [first, past] : clusters) {
      if (modes[first].kind == ModeKind::rigid_body || !(omega[first] > 0)) continue;
      ComplexMatrix x(modes[first].shape.size(), static_cast<Index>(past - first));
      for (std::size_t k = first; k < past; ++k) x.col(static_cast<Index>(k - first)) = modes[k].shape;
      const auto d = impedances->at(omega[first], x);
      if (!d) {
        if (modes[first].kind != ModeKind::local) s.reason = none_around;
        continue;
      }
      const Index rows = d->form.rows();
      const auto* of_matrices = dynamic_cast<const OfMatrices*>(impedances.get());
      const ComplexMatrix own = rows == x.rows() || !of_matrices ? x : ComplexMatrix(x(of_matrices->kept(), Eigen::all));
      const auto slopes = root_slopes(own, d->by_parameter, d->form, d->error);
      if (!slopes) continue;
      for (std::size_t k = first; k < past; ++k) {
        s.slope[k] = slopes->value(static_cast<Index>(k - first));
        s.error[k] = slopes->error(static_cast<Index>(k - first)) + std::abs(s.slope[k]) * open_part(own, *d);
      }
    }
    all.push_back(std::move(s));
  }
  return all;
}

// H(mΩ; Ω): its total derivative by Ω is m ∂H/∂ω + ∂H/∂Ω.
std::vector<Sensitivity> sensitivities(const ModelKind& model, const CriticalSpeeds& found, const std::string& speed,
                                       const std::vector<std::string>& keys) {
  std::vector<Sensitivity> all;
  for (const Parameter& p : parameters_of(model, keys)) {
    if (p.key == speed) continue;
    all.push_back({p, std::vector<double>(found.speeds.size(), unknown), std::vector<double>(found.speeds.size(), unknown), ""});
  }
  for (std::size_t k = 0; k < found.speeds.size(); ++k) {
    const CriticalSpeed& c = found.speeds[k];
    const auto turning = model.with({{speed, c.speed}});
    OfMatrices impedances(*turning);
    const double w = c.multiple * c.speed;
    if (!impedances.choose([&](double value) { return impedances.with(model, {{speed, value}}); }, c.speed)) continue;
    const ComplexMatrix x = c.shape;
    const auto by_speed = impedances.at(w, x);
    const ComplexMatrix form = c.multiple * by_speed->form - by_speed->by_parameter;
    for (Sensitivity& s : all) {
      const MatricesAt at = [&](double value) { return impedances.with(*turning, {{s.parameter.key, value}}); };
      if (!impedances.choose(at, s.parameter.value)) {
        s.reason = none_around;
        continue;
      }
      const auto d = impedances.at(w, x);
      const auto slope = root_slopes(x, d->by_parameter, form, d->error);
      if (!slope) continue;
      s.slope[k] = slope->value(0);
      s.error[k] = slope->error(0);
    }
  }
  return all;
}

}  // namespace gyromode
