#pragma once

#include "gyromode/appendage/spin_operators.h"
#include "gyromode/appendage/mass_properties.h"
#include "gyromode/roots/couplings.h"
#include "gyromode/roots/lifted.h"

#include <string>
#include <vector>

namespace gyromode {

/// Points along an appendage for a picture, and where a mode takes them.
struct Outline {
  std::string name;
  std::vector<Eigen::Vector3d> points;  ///< steady places, about the origin of the heights
};

/// Something flexible on the body of a spinning satellite, exact at any frequency. All that the solver knows of it:
/// coordinates of its own in a Lifted impedance, the count of its fixed-root frequencies, its rigid mass and, for
/// pictures, the motion of its points. A new kind is one class.
///
/// What add() adds is the excess over the appendage frozen in its steady place. Motion relative to the body is measured
/// in the body's axes, so that the tension of the steady state enters through the motion of the appendage alone.
class Appendage {
 public:
  virtual ~Appendage() = default;

  /// How many coordinates of its own it brings.
  virtual Index coordinates() const = 0;
  /// Mass and moments, frozen in the steady place.
  virtual MassProperties rigid() const = 0;
  /// Adds what couples what in the matrices of add(), at any frequency, from the geometry alone: an entry that is not
  /// stated here is exactly zero there.
  virtual void couple(Couplings& to, Index first) const = 0;
  /// Adds to the matrix its share of the body's six rows and columns, and its own rows and columns from `first` on; ω
  /// in rad per unit of time, > 0 or the limit 0.
  virtual void add(double omega, Lifted& to, Index first) const = 0;
  /// The same continued to complex ω (growth rate −Im ω): not Hermitian, analytic; `poles_below` is left alone.
  virtual void add(Complex omega, Lifted& to, Index first) const = 0;

  /// ∫ u dm in the plane of axes 1 and 2, of the displacement u relative to the body, for a null vector of the Lifted
  /// matrix: `body` its first six entries, `own` those of this appendage.
  virtual Eigen::Vector2cd first_moment(double omega, const ComplexVector& body, const ComplexVector& own) const = 0;
  /// Lines for a picture.
  virtual std::vector<Outline> outlines() const = 0;
  /// Displacement relative to the body of every point of the outlines (3 × points, one matrix an outline), for a null
  /// vector as above (Boland & Janssens 1979, Eq. 15).
  virtual std::vector<ComplexMatrix> displaced(double omega, const ComplexVector& body, const ComplexVector& own) const = 0;
};

}  // namespace gyromode
