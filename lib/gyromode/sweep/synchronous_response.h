#pragma once

#include "gyromode/base/progress.h"
#include "gyromode/motion/frequency_response.h"
#include "gyromode/spectrum/result.h"
#include "gyromode/sweep/spin_sample.h"

#include <vector>

namespace gyromode {

/// A force that goes round with a rotor: Ω²f e^{jmΩt} at the speed Ω > 0, as that of unbalanced masses does.
struct SynchronousForce {
  ComplexVector per_speed2;  ///< f, n
  double order = 1;          ///< m ≥ 0, in the axes of the model
};

/// q of q e^{jmΩt}: H(mΩ; Ω) q = Ω²f.
struct SynchronousPoint {
  double speed = 0;                     ///< Ω, rad per unit of time
  ComplexVector q;                      ///< as FrequencyPoint::q
  Driven driven = Driven::no;           ///< whether Ω is a critical speed that the force drives: `yes` is a resonance
  bool added = false;                   ///< not on the grid: put beside a resonance to show it
  std::optional<double> participation;  ///< of the critical speed that Ω is, or was put beside

  bool resonance() const { return driven == Driven::yes; }  ///< whether the response is unbounded here
};

/// The response over speeds, and the critical speeds that it meets.
struct SynchronousResponse {
  double order = 1;                      ///< of the force
  std::vector<SynchronousPoint> points;  ///< ascending in speed
  /// those in the range, driven or not; `omega` is the speed, the participation |Xᴴf| / (‖DX‖ ‖D⁻¹f‖), D² the diagonal
  /// of M + |K₀|/Ω²
  std::vector<DrivenMode> critical;
  Coverage coverage;         ///< whether all of them are there
  bool interrupted = false;  ///< work was stopped: higher speeds are left out

  std::vector<double> resonances() const;  ///< speeds, of those that the force drives, however weakly
};

/// On a grid of speeds (ascending, Ω ≥ 0), by one factorisation a point, with points beside every critical speed that
/// is driven. Where the model does not tell x from y (its matrices commute with the quarter turn of
/// `source.transverse`, entry by entry) a force that whirls one way does not drive modes that whirl the other way.
/// `progress` is told "speeds".
/// @throws InvalidArgument for sizes that do not fit; NotApplicable for models that are no family of matrices
SynchronousResponse synchronous_response(const SpinSource& source, const SynchronousForce& force, const Vector& speeds,
                                         const Progress& progress = {});

}  // namespace gyromode
