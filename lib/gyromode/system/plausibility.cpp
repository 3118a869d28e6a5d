#include "gyromode/system/plausibility.h"

#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/system/symmetry.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gyromode {

namespace {

constexpr double as_printed = 1e-6;      // relative: what people copy and print agrees to this
constexpr Index affordable_up_to = 300;  // eigenvalues of more cost a part of the solve

double size_of(const Matrix& a) { return a.size() == 0 ? 0 : a.cwiseAbs().maxCoeff(); }

bool softens(const Matrix& k2) {
  if (size_of(k2) == 0 || k2.rows() > affordable_up_to || size_of(skew_part(k2)) > as_printed * size_of(k2)) return false;
  const Vector values = lapack::symmetric_eigenvalues(symmetric_part(k2));
  return values(values.size() - 1) <= as_printed * size_of(k2);
}

// c of G₁ᵀM⁻¹G₁ = −c²K₂, or 0 where there is none.
double coriolis_factor(const SpinFamily& f) {
  const lapack::Cholesky mass(symmetric_part(f.mass));
  if (!mass.positive()) return 0;
  const Matrix half = mass.solve(f.gyroscopic_per_spin);
  const Matrix product = f.gyroscopic_per_spin.transpose() * half;
  const double factor = -product.cwiseProduct(f.stiffness_per_spin2).sum() / f.stiffness_per_spin2.squaredNorm();
  if (!(factor > 0) || size_of(product + factor * f.stiffness_per_spin2) > as_printed * size_of(product)) return 0;
  return std::sqrt(factor);
}

struct Factor {
  double value;
  std::string_view mistake;
};
constexpr double pi = std::numbers::pi;
const std::array<Factor, 7> named_factors{{{2 * pi, "Hz given or meant where rad/s are due"},
                                           {60, "values per minute and per second mixed"},
                                           {30 / pi, "rpm given or meant where rad/s are due"},
                                           {std::sqrt(1000.0), "mm and N with kg (consistent are m, N, kg and mm, N, t)"},
                                           {1000, "mm and m mixed"},
                                           {std::sqrt(9.80665), "kgf and N mixed"},
                                           {std::sqrt(386.0886), "lbf and lbm with inches (masses are lbf s²/in)"}}};

}  // namespace

std::vector<std::string> doubts_on(const SpinFamily& f) {
  if (!softens(f.stiffness_per_spin2)) return {};
  if (size_of(f.gyroscopic_per_spin) == 0 && size_of(f.gyroscopic) == 0) {
    return {
        "stiffness_per_spin2 softens with the spin, as in turning axes, and there is no gyroscopic_per_spin: in turning axes Coriolis "
        "forces belong to it, in fixed ones neither does"};
  }
  if (size_of(f.gyroscopic_per_spin) == 0) return {};
  const double c = coriolis_factor(f);
  if (c == 0 || std::abs(c - 2) <= as_printed) return {};
  return {
      fmt::format("gyroscopic_per_spin is {:.4g} of the Coriolis forces 2ΩM that belong to the softening of stiffness_per_spin2{}: is a "
                  "factor missing?",
                  0.5 * c, std::abs(c - 1) <= as_printed ? " (ΩM)" : "")};
}

std::vector<std::string> doubts_on(const System& s) {
  if (s.size() > affordable_up_to || size_of(s.gyroscopic()) > 0 || size_of(s.stiffness()) == 0) return {};
  const Vector values = lapack::symmetric_eigenvalues(s.stiffness());
  if (values(0) >= -as_printed * size_of(s.stiffness())) return {};
  return {"K is indefinite and G = 0: if K holds the softening of turning axes (−Ω²M), their Coriolis forces are missing"};
}

std::vector<std::string> doubts_on(const Labels& labels) {
  const auto in_millimetres = [](const std::string& label) {
    return label.find("[mm]") != std::string::npos || label.find("(mm)") != std::string::npos;
  };
  const auto at = std::find_if(labels.begin(), labels.end(), in_millimetres);
  if (at == labels.end()) return {};
  return {fmt::format("'{}' is in mm: with K in N/mm the masses are in t, or frequencies come out too low by √1000 = 31.6", *at)};
}

std::string doubt_on_unit(const std::vector<double>& found, const std::vector<double>& known) {
  std::vector<double> ratios;
  const std::size_t count = std::min(found.size(), known.size());
  for (std::size_t k = 0; k < count; ++k) {
    if (found[k] > 0 && known[k] > 0) ratios.push_back(known[k] / found[k]);
  }
  if (ratios.empty()) return "";
  const auto is = [&](double factor) {
    return std::all_of(ratios.begin(), ratios.end(), [&](double r) { return std::abs(r / factor - 1) < 1e-3; });
  };
  for (const Factor& f : named_factors) {
    for (const bool more : {true, false}) {
      if (is(more ? f.value : 1 / f.value))
        return fmt::format("the frequencies found are {} by {:.4g} than those known of the model: {}?", more ? "lower" : "higher", f.value,
                           f.mistake);
    }
  }
  return "";
}

}  // namespace gyromode
