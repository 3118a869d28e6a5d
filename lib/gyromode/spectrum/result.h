#pragma once

#include "gyromode/spectrum/verdict.h"
#include "gyromode/spectrum/window.h"
#include "gyromode/structure/definiteness.h"
#include "gyromode/structure/structure.h"
#include "gyromode/system/symmetry.h"

#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace gyromode {

/// `rigid_body`: a zero mode of K ≥ 0 (a constant solution, in first order); of a spacecraft spin phase, axial
/// translation and tilt of the momentum axis. `local`: the kept coordinates of a condensed model, or the body of a
/// spacecraft, take no part.
enum class ModeKind { vibration, rigid_body, local };
std::string_view to_string(ModeKind kind);

/// One motion Re(X e^{jωt}).
struct Mode {
  double omega = 0;                     ///< rad per unit of time, ≥ 0; a zero mode is one pair of zero roots (one root, in first order)
  int energy_sign = 1;                  ///< κ: 1, −1, or 0 where it cannot be told (zero modes, coinciding roots of opposite sign)
  ModeKind kind = ModeKind::vibration;  ///< what moves
  Index multiplicity = 1;               ///< how many modes this entry stands for
  /// ‖H(ω)X‖₂ / ((‖K‖ + ω‖G‖ + ω²‖M‖)‖X‖₂), 1-norms of matrices; of a spacecraft with exact booms |μ/(ω μ′)|, μ the
  /// eigenvalue of H_red that vanishes
  double residual = 0;
  double error_bound = 0;  ///< on |δω|, to first order
  /// how many modes rounding cannot tell apart here: of more than one the span is what is determined, not each shape
  Index cluster = 1;
  std::optional<std::array<double, 2>> bracket;  ///< [lo, hi] between which a count proves the root, where there is one
  /// displacement of the points of each outline, 3 × points, in the scale of the shape; of rotors and spacecraft, with
  /// shapes
  std::vector<ComplexMatrix> field;
  ComplexVector shape;  ///< empty unless asked for; largest entry 1 (the first of ties), n entries in the order of the labels
  /// Xᴴ(2ωM − jG)X of that shape (of first order XᴴIX): what a change of H is divided by (theory (T15)); its sign is
  /// energy_sign. 0 without shapes, of zero modes, and of a spacecraft with exact booms
  double form = 0;
};

/// A growing motion: e^{σt}, with ω = 0 for divergence, ω > 0 for flutter. It stands for the pair ±σ or the quadruple
/// ±σ ± jω.
struct UnstableMode {
  double growth_rate = 0;  ///< σ > 0, 1 per unit of time
  double omega = 0;        ///< rad per unit of time; 0 for divergence
  /// ‖(λ²M + λG + K)X‖₂ / ((‖K‖ + |λ|‖G‖ + |λ|²‖M‖)‖X‖₂), λ = σ + jω; of a spacecraft |μ/(λ μ′)|, μ the singular value
  /// of H_red(λ) that vanishes
  double residual = 0;
  double error_bound = 0;  ///< on |δλ|, to first order, or the radius of the disc in which it was counted
  ComplexVector shape;     ///< X of Re(X e^{(σ + jω)t}), largest entry 1; empty unless asked for, and of a spacecraft

  bool flutter() const { return omega > 0; }  ///< else divergence
};

enum class CoverageStatus { complete, incomplete, not_counted };
std::string_view to_string(CoverageStatus status);

/// Is every mode of the window there? `complete` only where an independent count by factorisations agrees with what was
/// found.
struct Coverage {
  CoverageStatus status = CoverageStatus::not_counted;  ///< the answer
  Window window;                                        ///< what was used: an endpoint on a mode is moved outward
  Window requested;                                     ///< as asked
  Index found = 0;                                      ///< with multiplicity
  std::optional<Index> counted;                         ///< by factorisations; nothing where the balance is open or work was stopped
  std::string reason;                                   ///< why not complete, for people; empty where complete
  /// Work was stopped. Of booms `window` is the part of which all modes were found by then; of matrices whole
  /// components are missing.
  bool interrupted = false;
};

enum class CountStatus { exact, signed_only, doubtful };
std::string_view to_string(CountStatus status);

/// How many modes a window holds, by factorisations at its ends (theory (T9), (T10)).
struct CountResult {
  Window window;                    ///< what was used: an endpoint on a mode is moved outward
  Window requested;                 ///< as asked
  std::optional<Index> count;       ///< modes in [a, b), zero modes included where a = 0; nothing where only the signed count is known
  Index signed_count = 0;           ///< modes of positive minus modes of negative energy
  Index zero = 0;                   ///< zero modes in the window
  std::array<Index, 2> negative{};  ///< n₋(H(a)), n₋(H(b)); H(0⁺) where a = 0
  CountStatus status = CountStatus::doubtful;  ///< what the count is worth
};

/// Points of a model in their steady places, in the axes and from the origin of the model file, for pictures.
struct ModelOutline {
  std::string name;                     ///< "cable 1"
  std::vector<Eigen::Vector3d> points;  ///< at rest, m
};

/// Everything `gyromode modes` reports, free of any output format.
struct ModesResult {
  Structure structure;                       ///< components and partition
  InertiaOfK stiffness;                      ///< of the whole K
  std::string solver;                        ///< one line: which solver served each component, and why
  bool first_order = false;                  ///< I q̇ + G q = 0
  bool transcendental = false;               ///< of a spacecraft with exact booms: infinitely many modes
  Stability stability = Stability::unknown;  ///< the verdict
  IndexBalance index_balance;                ///< what the verdict rests on
  double opposite_gap = 0;                   ///< smallest relative distance of roots of opposite energy sign; infinite where there is none
  Coverage coverage;                         ///< whether every mode of the window is there
  std::vector<ModelOutline> outlines;        ///< of rotors and spacecraft, where shapes were asked for
  std::vector<Mode> modes;                   ///< in the window, ascending in ω
  std::vector<Mode> negative_modes;          ///< every mode of negative or undecided energy, whatever the window
  std::vector<UnstableMode> unstable;        ///< all, whatever the window
  std::vector<Repair> repairs;               ///< of matrices that were not (skew-)symmetric, with what that does to the modes listed

  /// Whether every mode of the window was found, and counted.
  bool is_complete() const { return coverage.status == CoverageStatus::complete; }
  /// ω of the modes, ascending, rad per unit of time.
  std::vector<double> frequencies() const;
  /// The shapes of the modes, n × (number of modes), in the order of the labels. @throws InvalidArgument where they
  /// were not asked for
  ComplexMatrix shapes() const;
  /// Leaves out shapes and displacements.
  void drop_shapes();
  /// Makes the verdict `unknown` where it is milder and a repair is doubtful (Repair::doubtful()).
  void withhold_doubtful_verdict();
  /// What is to be said of windows that were moved, and of more modes than the `lowest` asked for, for people.
  std::vector<std::string> remarks(std::optional<Index> lowest = std::nullopt) const;
};

/// A line a mode, ω in rad per unit of time with energy sign and kind, then verdict and coverage.
std::ostream& operator<<(std::ostream& out, const ModesResult& result);

}  // namespace gyromode
