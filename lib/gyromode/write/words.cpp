#include "gyromode/write/words.h"

#include <fmt/format.h>

#include <cmath>

namespace gyromode::io {

namespace {

std::string plural(Index n, std::string_view one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

}  // namespace

std::string joined(const Labels& labels, const std::vector<Index>& coordinates) {
  constexpr std::size_t most = 12;
  std::string out;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    if (k == most) return out + fmt::format(", … ({} in all)", coordinates.size());
    out += (k == 0 ? "" : ", ") + labels[static_cast<std::size_t>(coordinates[k])];
  }
  return out.empty() ? "none" : out;
}

std::string model_words(const Model& model) {
  const std::string axes = model.frame == Frame::unknown ? "" : fmt::format("; {} axes", to_string(model.frame));
  return fmt::format("{} ({}, {}{})", model.title, plural(model.size(), "coordinate"), model.body->in_words(), axes);
}

std::string repaired_words(const std::vector<Repair>& repairs) {
  const bool beyond =
      std::any_of(repairs.begin(), repairs.end(), [](const Repair& r) { return r.largest_effect.value_or(0) > r.error_bound; });
  return beyond ? "; of the matrices as symmetrised: what was dropped can change it" : "";
}

std::string class_words(const Model& model, const Structure& s) {
  if (model.body->transcendental()) {
    return fmt::format("transcendental (exact booms), {}", s.system_class() == SystemClass::quadrature
                                                               ? "quadrature: every mode moves partly in phase, partly in quadrature"
                                                               : "fully complex: phases differ from mode to mode");
  }
  switch (s.system_class()) {
    case SystemClass::quadrature: return "quadrature: every mode moves partly in phase, partly in quadrature";
    case SystemClass::hidden_quadrature:
      return "hidden quadrature: in phase and in quadrature in other coordinates, by a reversing symmetry";
    default: return "general: phases differ from mode to mode";
  }
}

std::string stiffness_words(const InertiaOfK& k) {
  if (k.definiteness() == Definiteness::positive) return "K positive definite";
  if (k.definiteness() == Definiteness::semidefinite) return fmt::format("K positive semidefinite, {} zero", k.zero);
  return fmt::format("K indefinite, {} negative{}", k.negative, k.zero > 0 ? fmt::format(" and {} zero", k.zero) : "");
}

std::string stability_words(Stability s) {
  switch (s) {
    case Stability::stable: return "stable";
    case Stability::gyroscopically_stabilised:
      return "gyroscopically stabilised: stable without damping, but some modes have negative energy and damping destabilises them";
    case Stability::marginal: return "marginal: a backward error of rounding size changes the verdict";
    case Stability::unstable: return "unstable";
    default: return "unknown: the index balance does not close";
  }
}

std::string window_words(const Window& w, FrequencyUnit unit) {
  const double a = in_unit(w.a, unit), b = in_unit(w.b, unit);
  return std::isinf(b) ? fmt::format("[{:.6g}, ∞) {}", a, to_string(unit)) : fmt::format("[{:.6g}, {:.6g}) {}", a, b, to_string(unit));
}

std::string balance_words(const IndexBalance& b) {
  return fmt::format("{}: n₋(K) = {} = {} divergent + 2·{} flutter + 2·{} of negative energy{}", b.closed ? "closed" : "NOT closed",
                     b.negative, b.real_pairs, b.quadruples, b.negative_energy,
                     b.zero_negative > 0 ? fmt::format(" + {} at zero", b.zero_negative) : "");
}

std::string coverage_words(const Coverage& c, FrequencyUnit unit) {
  std::string out = fmt::format("{}: found {}", to_string(c.status), c.found);
  if (c.counted) out += fmt::format(", counted {}", *c.counted);
  out += fmt::format(" in {}", window_words(c.window, unit));
  return c.reason.empty() ? out : out + " — " + c.reason;
}

std::string complex_words(const Complex& z) {
  if (z.imag() == 0) return fmt::format("{:.6g}", z.real());
  if (z.real() == 0) return fmt::format("{:.6g}j", z.imag());
  return fmt::format("{:.6g}{:+.6g}j", z.real(), z.imag());
}

std::string largest_in(const Labels& labels, const ComplexVector& shape) {
  if (shape.size() == 0) return "";
  Index at = 0;
  shape.cwiseAbs().maxCoeff(&at);
  return labels[static_cast<std::size_t>(at)];
}

}  // namespace gyromode::io
