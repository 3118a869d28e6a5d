#include "gyromode/write/result_text.h"
#include "gyromode/write/text_parts.h"
#include "gyromode/structure/symmetry_words.h"

#include <fmt/format.h>

#include <numbers>

namespace gyromode::io {

namespace {

std::string witness_walk(const Labels& labels, const OddCycle& w) {
  std::string out = labels[static_cast<std::size_t>(w.coordinates.front())];
  for (std::size_t k = 0; k < w.kinds.size(); ++k) {
    const Index next = w.coordinates[(k + 1) % w.coordinates.size()];
    out += fmt::format(" —{}— {}", w.kinds[k] == CouplingKind::cross ? "G" : "M,K", labels[static_cast<std::size_t>(next)]);
  }
  return out;
}

std::string symmetry_facts(const Model& model, const std::vector<SymmetryFinding>& findings, Format format) {
  std::string out;
  for (const SymmetryFinding& f : findings) {
    if (f.reflection) {
      out += fact(format, "symmetry", in_words(*f.reflection, chosen(model.labels(), f.coordinates)));
      out += fact(format, "", fmt::format("commutes with K, anticommutes with G to {:.1e}, where rounding explains {:.1e}", f.departure, f.threshold));
    } else {
      out += fact(format, "symmetry", fmt::format("none reverses the spin: the nearest reflection misses by {:.2g}, where rounding explains {:.1e}", f.departure, f.threshold));
    }
  }
  return out;
}

std::string_view sign_words(int sign) { return sign > 0 ? "positive" : sign < 0 ? "negative" : "zero to rounding: a resonance"; }

std::string how_words(const Realified& at) {
  switch (at.how) {
    case Realification::partition: return "T = diag(1 in phase, −j in quadrature), the same at every ω";
    case Realification::angle: return fmt::format("S(ψ) with ψ = {:.8g}°, for this ω", *at.angle * 180 / std::numbers::pi);
    default: return "reflections and phases, for this ω: H* is tridiagonal";
  }
}

std::string complex_table(const std::string& title, const Labels& labels, const ComplexMatrix& a, Format format) {
  std::vector<std::string> head{title};
  head.insert(head.end(), labels.begin(), labels.end());
  Grid grid(head);
  for (Index i = 0; i < a.rows(); ++i) {
    std::vector<std::string> row{labels[static_cast<std::size_t>(i)]};
    for (Index k = 0; k < a.cols(); ++k) row.push_back(complex_cell(a(i, k)));
    grid.add(std::move(row));
  }
  return written(grid, format);
}

}  // namespace

std::string structure_text(const Model& model, const StructureReport& r, Format format) {
  const Structure& s = r.structure;
  std::string out = heading(format, model_line(model));
  out += fact(format, "class", class_words(model, s));
  if (s.system_class() == SystemClass::quadrature) {
    out += fact(format, "in phase", joined(model.labels(), s.in_phase()));
    out += fact(format, "quadrature", joined(model.labels(), s.in_quadrature()));
    out += fact(format, "H*", "T = diag(1 in phase, −j in quadrature) makes H(ω) real symmetric at every ω");
  } else if (const auto w = s.witness(); w && !w->kinds.empty()) {
    out += fact(format, s.system_class() == SystemClass::hidden_quadrature ? "not visible" : "why not", "a closed walk with an odd number of G couplings: " + witness_walk(model.labels(), *w));
  }
  out += symmetry_facts(model, r.symmetries, format);
  if (r.stiffness_applies) out += fact(format, "stiffness", stiffness_words(r.stiffness));
  out += fact(format, "components", fmt::format("{}", s.components.size()));
  if (model.ignored) out += fact(format, "left out", in_words(*model.ignored));
  if (s.components.size() > 1) {
    Grid grid({"component", "coordinates", "class"});
    for (std::size_t c = 0; c < s.components.size(); ++c) {
      grid.add({fmt::format("{}", c + 1), joined(model.labels(), s.components[c].coordinates), s.components[c].quadrature() ? "quadrature" : s.components[c].hidden_quadrature() ? "hidden quadrature" : "general"});
    }
    out += "\n" + written(grid, format);
  }
  if (!r.clamped_booms.empty()) {
    Grid grid({"boom on a body held", "ω [rad/s]"});
    for (const ClampedBoom& h : r.clamped_booms) {
      std::string list;
      for (const double w : h.frequencies) list += fmt::format("{}{:.6g}", list.empty() ? "" : "  ", w);
      grid.add({h.name, list});
    }
    out += "\n" + written(grid, format);
  }
  if (!r.effective_axes.empty()) {
    Grid grid({"ω [rad/s]", "ψ [°]"});
    for (const EffectiveAxes& e : r.effective_axes) grid.add({fmt::format("{:.10g}", e.omega), fmt::format("{:.8g}", e.angle * 180 / std::numbers::pi)});
    out += "\nψ: from axis 1 to the principal axis of the effective inertia of hub and booms at the frequency of each mode;\n   about it rotations are in phase, across it in quadrature\n" +
           written(grid, format);
  }
  if (r.at) {
    const Realified& at = r.at->realified;
    out += "\n" + complex_table(fmt::format("H({:.6g} rad/s)", r.at->omega), model.labels(), at.impedance, format);
    out += "\n" + complex_table("U", model.labels(), at.unitary, format);
    std::vector<std::string> head{"H* = UᴴHU"};
    for (const std::string& label : model.labels()) head.push_back(label);
    Grid grid(head);
    for (Index i = 0; i < at.real_symmetric.rows(); ++i) {
      std::vector<std::string> row{model.labels()[static_cast<std::size_t>(i)]};
      for (Index k = 0; k < at.real_symmetric.cols(); ++k) row.push_back(fmt::format("{:.6g}", at.real_symmetric(i, k)));
      grid.add(std::move(row));
    }
    out += "\n" + written(grid, format);
    out += "\n" + fact(format, "U", how_words(at)) + fact(format, "n₋(H)", fmt::format("{}; det H is {}", at.negative(), sign_words(at.determinant_sign())));
  }
  return out;
}

}  // namespace gyromode::io
