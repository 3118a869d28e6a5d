#pragma once

#include "gyromode/appendage/mass_properties.h"
#include "gyromode/appendage/parts.h"
#include "gyromode/base/broken_law.h"
#include "gyromode/base/labels.h"

#include <optional>
#include <string>
#include <vector>

namespace gyromode {

/// The rigid central body alone. The origin of all heights and positions is its centre of mass.
struct Body {
  double mass = 0;                                    ///< kg
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< kg m², about its own centre of mass; off-diagonal entries −∫ xy dm …
};

/// The first law that a part breaks, or nothing.
std::optional<BrokenLaw> broken_law(const Body& body);
std::optional<BrokenLaw> broken_law(const Cable& cable);
std::optional<BrokenLaw> broken_law(const Beam& beam);
std::optional<BrokenLaw> broken_law(const SpringMass& mass);

/// A rigid body with booms and sprung masses that spins steadily about its axis 3. One that exists is in equilibrium:
/// its parts are lawful, its mass centre is on axis 3 and the products of inertia J13, J23 of the complete satellite
/// vanish (docs/booms.md (B12)), within `tolerance`.
class Spacecraft {
 public:
  static constexpr double tolerance = 1e-9;  ///< of the mass centre relative to Σ∫r dm, of J13 and J23 to J33

  /// Throws LawBroken; for no equilibrium, by how much, in N and N m.
  Spacecraft(double spin, Body body, std::vector<Cable> cables = {}, std::vector<Beam> beams = {}, std::vector<SpringMass> masses = {});

  double spin() const { return spin_; }                              ///< rad/s, > 0, about axis 3
  const Body& body() const { return body_; }                         ///< the rigid central body
  const std::vector<Cable>& cables() const { return cables_; }       ///< wire booms
  const std::vector<Beam>& beams() const { return beams_; }          ///< axial booms
  const std::vector<SpringMass>& masses() const { return masses_; }  ///< masses on springs

  /// Of the complete satellite, frozen, about its own centre of mass P.
  const MassProperties& rigid() const { return rigid_; }
  /// Height of P above the body's centre of mass.
  double centre() const { return centre_; }

  /// zeta1 zeta2 zeta3 (displacement of P, m, in turning axes), theta1 theta2 theta3 (rotation vector of the body).
  const Labels& labels() const;
  Index size() const { return 6; }  ///< of (ζ, θ)

 private:
  void require_equilibrium() const;

  double spin_;
  Body body_;
  std::vector<Cable> cables_;
  std::vector<Beam> beams_;
  std::vector<SpringMass> masses_;
  MassProperties rigid_;
  double centre_ = 0;
};

}  // namespace gyromode
