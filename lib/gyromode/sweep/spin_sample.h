#pragma once

#include "gyromode/modes/modes.h"
#include "gyromode/sweep/whirl.h"
#include "gyromode/system/spin_family.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace gyromode {

/// A mode at one spin, as a sweep needs it.
struct SampledMode {
  double omega = 0;                       ///< rad per unit of time, > 0
  double error = 0;                       ///< on |δω|, to first order
  std::optional<double> slope;            ///< dω/dΩ (theory (T15)); nothing where it is not known
  int energy_sign = 1;                    ///< κ
  Index multiplicity = 1;                 ///< how many modes this stands for
  Index block = -1;                       ///< FamilyBlocks; of a spacecraft by body and booms; −1: of several
  std::optional<Whirl> whirl;             ///< where the model has places
  std::vector<FixedAxesPart> fixed_axes;  ///< what it is in axes that do not turn, if those of the model turn with the spin
  ComplexVector shape;                    ///< n, largest entry 1
};

/// The modes of a model at one spin in (0, b), without rigid-body modes.
struct SpinSample {
  double spin = 0;                           ///< rad per unit of time
  std::vector<SampledMode> modes;            ///< ascending
  Coverage coverage;                         ///< whether all of the window are there
  Stability stability = Stability::unknown;  ///< the verdict
  IndexBalance balance;                      ///< branches begin and end within the window only where it changes
  std::vector<UnstableMode> unstable;        ///< all
};

/// What a model says of itself to a sweep over its spin.
struct SpinSource {
  std::function<ModesResult(double spin, const ModesOptions& options)> modes;  ///< may be called from several threads
  /// H(ω; Ω), for slopes, of a model that is no family of matrices: as a function of ω > 0 and Ω.
  std::function<ComplexMatrix(double omega, double spin)> impedance;
  std::shared_ptr<const SpinFamily> family;  ///< null of others
  std::vector<OrbitCoordinates> places;      ///< whose orbits say how a mode whirls
  /// The coordinates that `places` number, of a shape of the family; empty: those of the shape.
  std::function<ComplexVector(const ComplexVector& shape)> seen;
  /// The family is the projection of a larger one: what it says of the whole it says to the errors of its modes, and
  /// counts of it are no counts of the whole.
  bool projected = false;
  std::vector<OrbitCoordinates> transverse;  ///< components x and y of all vectors across the axis: places and tilts
};

}  // namespace gyromode
