#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/base/types.h"
#include "gyromode/sparse/sparse_system.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/system/system.h"

#include <optional>
#include <string_view>
#include <vector>

namespace gyromode {

/// Whether a force e^{jωt} drives a mode: `no` where the structure says so, the force and the mode having no coordinate
/// in common; `undecided` where the force meets it by less than the error of its shape, so that rounding of the
/// matrices decides.
enum class Driven { no, undecided, yes };
std::string_view to_string(Driven d);

/// A mode as a steady force meets it.
struct DrivenMode {
  double omega = 0;  ///< rad per unit of time
  double error = 0;  ///< bound on |δω|
  /// |Xᴴf| / (√(XᴴMX) √(fᵀM⁻¹f)), of the span where modes coincide: from 0, not driven, to 1; does not depend on units.
  /// Of zero roots the same after cancellation
  double participation = 0;
  double resolution = 0;       ///< the error of the participation: up to this it says nothing
  Driven driven = Driven::no;  ///< whether the force drives it
};

/// q of q e^{jωt} under a force f e^{jωt}: H(ω) q = f.
struct FrequencyPoint {
  double omega = 0;  ///< rad per unit of time
  /// n; empty at a resonance; on a mode that is not driven, or of which this cannot be told, the limit from both sides
  ComplexVector q;
  /// whether ω is that of a mode, within its error, that the force drives: `yes` is a resonance, the response is
  /// unbounded; `undecided`: q holds if it is none
  Driven driven = Driven::no;
  bool added = false;                   ///< not on the grid: put beside a resonance to show it
  std::optional<double> participation;  ///< of the mode that ω is on, or was put beside

  bool resonance() const { return driven == Driven::yes; }  ///< whether the response is unbounded here
};

/// The response over a grid, and the modes that it meets.
struct FrequencyResponse {
  std::vector<FrequencyPoint> points;  ///< ascending in ω
  std::vector<DrivenMode> modes;       ///< those in the range of the grid, driven or not
  bool interrupted = false;            ///< work was stopped: frequencies of the grid from some on are left out
  /// of a sparse system, whose modes are searched window by window: whether all of the range are known
  std::optional<Coverage> coverage;

  std::vector<double> resonances() const;  ///< frequencies of the modes that the force drives, however weakly
};

/// H(ω)⁻¹f on a grid (ascending, ω ≥ 0, rad per unit of time), by one factorisation a point; of sparse systems by few
/// (ReducedSweep). With `resolve` points at ω_s(1 ± 10⁻²) … ω_s(1 ± 10⁻⁵) are put beside every mode ω_s in range that
/// the force drives. `progress` is told "frequencies". Throws InvalidArgument where sizes do not fit, the grid does not
/// ascend, or a number is not finite.
FrequencyResponse frequency_response(const System& system, const Vector& force, const Vector& grid, bool resolve = true,
                                     const Progress& progress = {});
/// The same of a sparse system: its modes in the range are those of find_modes(); the entries of q are the coordinates
/// `chosen`, all where it is empty. Throws also what find_modes() throws.
FrequencyResponse frequency_response(const SparseSystem& system, const Vector& force, const Vector& grid, const std::vector<Index>& chosen,
                                     bool resolve = true, const Progress& progress = {});

}  // namespace gyromode
