#pragma once

#include "gyromode/motion/frequency_response.h"

#include <vector>

namespace gyromode {

/// A pole of a steady response, and what the force does on its shape.
struct PoleMet {
  double at = 0;     ///< the frequency, or the speed, > 0
  double error = 0;  ///< bound on it
  double work2 = 0;  ///< |Xᴴf|² / XᴴMX
  bool met = true;   ///< false where the structure says that the force does not reach the shape
};

/// A force on one part of a model among all of it.
struct ForceSize {
  double own = 0;    ///< √(fᴴM⁻¹f) on the part that the poles are of
  double whole = 0;  ///< on all parts
  Index size = 0;    ///< coordinates of the part
};

/// Whether the force drives the poles, which ascend; those that their errors let coincide are judged as one.
std::vector<DrivenMode> judged(const std::vector<PoleMet>& poles, const ForceSize& force);
/// From the participation and the error of it, of a mode that is met or not.
Driven judged(bool met, double participation, double resolution);

}  // namespace gyromode
