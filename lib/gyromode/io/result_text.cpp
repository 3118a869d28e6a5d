#include "gyromode/io/result_text.h"

#include "gyromode/io/grid.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace gyromode::io {

namespace {

std::string plural(Index n, std::string_view one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); }

std::string written(const Grid& grid, Format format) { return format == Format::markdown ? grid.markdown() : grid.aligned(); }

// "key: value" lines above a table; a bullet each in Markdown.
std::string fact(Format format, std::string_view key, const std::string& value) {
  return format == Format::markdown ? fmt::format("- **{}**: {}\n", key, value) : fmt::format("{:<11} {}\n", key, value);
}

std::string heading(Format format, const std::string& title) {
  return format == Format::markdown ? fmt::format("## {}\n\n", title) : fmt::format("{}\n\n", title);
}

std::string joined(const Labels& labels, const std::vector<Index>& coordinates) {
  constexpr std::size_t most = 12;
  std::string out;
  for (std::size_t k = 0; k < coordinates.size(); ++k) {
    if (k == most) return out + fmt::format(", … ({} in all)", coordinates.size());
    out += (k == 0 ? "" : ", ") + labels[static_cast<std::size_t>(coordinates[k])];
  }
  return out.empty() ? "none" : out;
}

std::string witness_walk(const Labels& labels, const OddCycle& w) {
  std::string out = labels[static_cast<std::size_t>(w.coordinates.front())];
  for (std::size_t k = 0; k < w.kinds.size(); ++k) {
    const Index next = w.coordinates[(k + 1) % w.coordinates.size()];
    out += fmt::format(" —{}— {}", w.kinds[k] == CouplingKind::cross ? "G" : "M,K", labels[static_cast<std::size_t>(next)]);
  }
  return out;
}

std::string stiffness_words(const Stiffness& k) {
  if (k.sign == Sign::positive) return "K positive definite";
  if (k.sign == Sign::semidefinite) return fmt::format("K positive semidefinite, {} zero", k.zero);
  return fmt::format("K indefinite, {} negative{}", k.negative, k.zero > 0 ? fmt::format(" and {} zero", k.zero) : "");
}

std::string class_words(const Model& model, const Structure& s) {
  if (std::holds_alternative<Spacecraft>(model.system)) {
    return fmt::format("transcendental (exact booms), {}", s.system_class() == SystemClass::quadrature ? "quadrature: every mode moves partly in phase, partly in quadrature"
                                                                                                         : "fully complex: phases differ from mode to mode");
  }
  return s.system_class() == SystemClass::quadrature ? "quadrature: every mode moves partly in phase, partly in quadrature"
                                                      : "general: phases differ from mode to mode";
}

std::string stability_words(Stability s) {
  switch (s) {
    case Stability::stable: return "stable";
    case Stability::gyroscopically_stabilised: return "gyroscopically stabilised: stable without damping, but some modes have negative energy and damping destabilises them";
    case Stability::marginal: return "marginal: a backward error of rounding size changes the verdict";
    case Stability::unstable: return "unstable";
    default: return "unknown: the index balance does not close";
  }
}

std::string window_words(const Window& w) {
  return std::isinf(w.b) ? fmt::format("[{:.6g}, ∞)", w.a) : fmt::format("[{:.6g}, {:.6g})", w.a, w.b);
}

std::string coverage_words(const Coverage& c) {
  std::string out = fmt::format("{}: found {}", word(c.status), c.found);
  if (c.counted) out += fmt::format(", counted {}", *c.counted);
  out += fmt::format(" in {} rad/s", window_words(c.window));
  return c.reason.empty() ? out : out + " — " + c.reason;
}

std::string sign_word(const Mode& m) { return m.energy_sign > 0 ? "+" : m.energy_sign < 0 ? "−" : "0"; }

std::string complex_cell(const Complex& z) {
  if (z.imag() == 0) return fmt::format("{:.6g}", z.real());
  if (z.real() == 0) return fmt::format("{:.6g}j", z.imag());
  return fmt::format("{:.6g}{:+.6g}j", z.real(), z.imag());
}

std::string frequency_table(const std::vector<Mode>& modes, Format format) {
  Grid grid({"#", "ω [rad/s]", "f [Hz]", "energy", "residual", "kind"});
  for (std::size_t k = 0; k < modes.size(); ++k) {
    const Mode& m = modes[k];
    grid.add({fmt::format("{}", k + 1), fmt::format("{:.15g}", m.omega), fmt::format("{:.10g}", m.omega / (2 * std::numbers::pi)), sign_word(m),
              fmt::format("{:.1e}", m.residual), std::string(word(m.kind))});
  }
  return written(grid, format);
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

std::string unstable_table(const std::vector<UnstableMode>& modes, Format format) {
  Grid grid({"growth rate [1/s]", "ω [rad/s]", "kind"});
  for (const UnstableMode& u : modes) {
    grid.add({fmt::format("{:.15g}", u.growth_rate), fmt::format("{:.15g}", u.omega), u.flutter() ? "flutter" : "divergence"});
  }
  return written(grid, format);
}

std::string balance_words(const IndexBalance& b) {
  return fmt::format("{}: n₋(K) = {} = {} divergent + 2·{} flutter + 2·{} of negative energy{}", b.closed ? "closed" : "NOT closed", b.negative, b.real_pairs,
                     b.quadruples, b.negative_energy, b.zero_negative > 0 ? fmt::format(" + {} at zero", b.zero_negative) : "");
}

std::string model_line(const Model& model) {
  return fmt::format("{} ({}, {})", model.title, plural(model.size(), "coordinate"), model.kind == "first_order" ? "first order" : std::holds_alternative<Spacecraft>(model.system) ? "of the body, exact booms; turning axes" : "M, G, K in turning axes");
}

}  // namespace

std::string modes_text(const Model& model, const ModesResult& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "class", class_words(model, r.structure) + (r.first_order ? "" : "; " + stiffness_words(r.stiffness)));
  if (r.structure.largest_ignored_coupling > 0) {
    out += fact(format, "ignored", fmt::format("couplings up to {:.2g} of the largest entry were left out, as asked", r.structure.largest_ignored_coupling));
  }
  out += fact(format, "solver", r.path);
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
  out += fact(format, "status", std::string(word(r.status)));
  return out;
}

std::string structure_text(const Model& model, const StructureReport& r, Format format) {
  const Structure& s = r.structure;
  std::string out = heading(format, model_line(model));
  out += fact(format, "class", class_words(model, s));
  if (s.system_class() == SystemClass::quadrature) {
    out += fact(format, "in phase", joined(model.labels(), s.in_phase()));
    out += fact(format, "quadrature", joined(model.labels(), s.in_quadrature()));
    out += fact(format, "H*", "T = diag(1 in phase, −j in quadrature) makes H(ω) real symmetric at every ω");
  } else if (const auto w = s.witness(); w && !w->kinds.empty()) {
    out += fact(format, "why not", "a closed walk with an odd number of G couplings: " + witness_walk(model.labels(), *w));
  }
  if (r.stiffness_applies) out += fact(format, "stiffness", stiffness_words(r.stiffness));
  out += fact(format, "components", fmt::format("{}", s.components.size()));
  if (r.coupling_tolerance > 0) {
    out += fact(format, "tolerance", fmt::format("couplings up to {:.2g} of the largest entry count as none; the largest left out is {:.2g}", r.coupling_tolerance,
                                                 s.largest_ignored_coupling));
  }
  if (s.components.size() > 1) {
    Grid grid({"component", "coordinates", "class"});
    for (std::size_t c = 0; c < s.components.size(); ++c) {
      grid.add({fmt::format("{}", c + 1), joined(model.labels(), s.components[c].coordinates), s.components[c].quadrature() ? "quadrature" : "general"});
    }
    out += "\n" + written(grid, format);
  }
  if (!r.held_booms.empty()) {
    Grid grid({"boom on a body held", "ω [rad/s]"});
    for (const HeldBoom& h : r.held_booms) {
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
    std::vector<std::string> head{fmt::format("H*({:.6g} rad/s)", r.at->omega)};
    for (const std::string& label : model.labels()) head.push_back(label);
    Grid grid(head);
    for (Index i = 0; i < r.at->real_symmetric.rows(); ++i) {
      std::vector<std::string> row{model.labels()[static_cast<std::size_t>(i)]};
      for (Index k = 0; k < r.at->real_symmetric.cols(); ++k) row.push_back(fmt::format("{:.6g}", r.at->real_symmetric(i, k)));
      grid.add(std::move(row));
    }
    out += "\n" + written(grid, format);
  }
  return out;
}

std::string stability_text(const Model& model, const ModesResult& r, Format format) {
  std::string out = heading(format, model_line(model));
  out += fact(format, "stability", stability_words(r.stability));
  if (!r.first_order) {
    out += fact(format, "stiffness", stiffness_words(r.stiffness));
    out += fact(format, "balance", balance_words(r.index_balance));
  }
  if (std::isfinite(r.opposite_gap)) out += fact(format, "margin", fmt::format("nearest roots of opposite energy sign are {:.3g} apart, relative", r.opposite_gap));
  if (!r.negative_modes.empty()) out += "\nmodes of negative energy\n" + frequency_table(r.negative_modes, format);
  if (!r.unstable.empty()) out += "\n" + unstable_table(r.unstable, format);
  return out;
}

}  // namespace gyromode::io
