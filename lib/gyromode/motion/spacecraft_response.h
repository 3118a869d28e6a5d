#pragma once

#include "gyromode/elements/boom_point.h"
#include "gyromode/motion/response.h"

#include <algorithm>

namespace gyromode {

/// The motion of a spacecraft from (ζ, θ) and their rates, booms at first undeformed and at rest relative to the body,
/// in turning axes, m and rad. The booms are finite elements of high degree (Mesh): with the default one, frequencies
/// up to some twenty spins agree with the exact fields to 1e-10. The mass centre of the whole moves by itself, exactly:
/// straight and steady, which in turning axes is the double root at the spin; body and booms move about it.
class SpacecraftResponse {
 public:
  /// `initial` has six displacements and six rates; `forces` act on the six (forces at P along ζ, torques along θ). The
  /// points report their displacement ζ + θ × p + u. Throws InvalidArgument for sizes and points that do not fit.
  SpacecraftResponse(const Spacecraft& s, const State& initial, const std::vector<Force>& forces = {},
                     const std::vector<BoomPoint>& points = {});
  SpacecraftResponse(const Spacecraft& s, const State& initial, const std::vector<Force>& forces, const std::vector<BoomPoint>& points,
                     const Mesh& mesh);

  /// zeta1 … theta3, then x, y, z of every point.
  const Labels& labels() const { return labels_; }
  State at(double t) const;
  History at(const Vector& times, const Progress& progress = {}) const;
  /// Of body and booms about the mass centre; shapes in the order of labels().
  const std::vector<ModalShare>& modal() const { return modal_; }
  const Response& about_centre() const { return about_centre_; }
  double departure() const { return std::max(about_centre_.departure(), centre_.departure()); }
  double phase_error(double t) const { return std::max(about_centre_.phase_error(t), centre_.phase_error(t)); }
  const Mesh& mesh() const { return mesh_; }
  Index coordinates() const { return outputs_.cols(); }

  /// Degree enough for smooth motion of every boom, and few enough coordinates for a dense solver.
  static Mesh mesh_for(const Spacecraft& s);

 private:
  struct Setup;
  SpacecraftResponse(const Spacecraft& s, const Setup& setup, const std::vector<BoomPoint>& points, const Mesh& mesh);

  Mesh mesh_;
  Labels labels_;
  Matrix outputs_;  // outputs × n: what the coordinates of the twin add to each
  Response about_centre_, centre_;
  std::vector<ModalShare> modal_;
};

}  // namespace gyromode
