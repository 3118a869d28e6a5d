#include "gyromode/motion/spacecraft_response.h"

#include "gyromode/motion/history.h"

#include "gyromode/base/error.h"
#include "gyromode/modes/shape.h"

#include <algorithm>

namespace gyromode {

namespace {

// A free mass in turning axes: a double root at the spin across, zero along the axis.
System free_mass(double mass, double spin) {
  Matrix g = Matrix::Zero(3, 3), k = Matrix::Zero(3, 3);
  g(0, 1) = -2 * mass * spin;
  g(1, 0) = 2 * mass * spin;
  k(0, 0) = k(1, 1) = -mass * spin * spin;
  return System(mass * Matrix::Identity(3, 3), g, k);
}

// Rows ζ, θ and the points, on the coordinates of the twin.
Matrix output_map(const Spacecraft& s, const Mesh& mesh, const Twin& twin, const std::vector<BoomPoint>& points) {
  const Index n = twin.system.size();
  Matrix rows = Matrix::Zero(6 + 3 * static_cast<Index>(points.size()), n);
  rows.topRows(3) = twin.body_displacement;
  rows.block(3, 0, 3, 3).setIdentity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto three = rows.middleRows(6 + 3 * static_cast<Index>(k), 3);
    three = twin.body_displacement + relative_displacement(s, mesh, twin.system, points[k]);
    const Eigen::Vector3d p = steady_place(s, points[k]);
    Eigen::Matrix3d turn;  // θ × p
    turn << 0, p(2), -p(1), -p(2), 0, p(0), p(1), -p(0), 0;
    three.leftCols(3) += turn;
  }
  return rows;
}

}  // namespace

struct SpacecraftResponse::Setup {
  Twin twin;
  System centre;
  State about, of_centre;
  std::vector<Force> on_twin, on_centre;

  Setup(const Spacecraft& s, const State& initial, const std::vector<Force>& forces, const Mesh& mesh)
      : twin(twin_of(s, mesh)), centre(free_mass(s.rigid().mass, s.spin())) {
    if (initial.q.size() != 6 || initial.qdot.size() != 6)
      throw InvalidArgument("a spacecraft starts from six displacements and six rates: zeta1 … theta3");
    const Index n = twin.system.size();
    about = {Vector::Zero(n), Vector::Zero(n)};
    about.q.head<3>() = initial.q.tail<3>();
    about.qdot.head<3>() = initial.qdot.tail<3>();
    of_centre = {initial.q.head<3>() - twin.body_displacement * about.q, initial.qdot.head<3>() - twin.body_displacement * about.qdot};
    for (const Force& f : forces) {
      if (f.amplitude.size() != 6) throw InvalidArgument("a force on a spacecraft has six components: zeta1 … theta3");
      Force own = f, whole = f;
      own.amplitude = twin.body_displacement.transpose() * f.amplitude.head<3>();
      own.amplitude.head<3>() += f.amplitude.tail<3>();
      whole.amplitude = f.amplitude.head<3>();
      on_twin.push_back(std::move(own));
      on_centre.push_back(std::move(whole));
    }
  }
};

Mesh SpacecraftResponse::mesh_for(const Spacecraft& s) {
  constexpr Index coordinates = 300, elements = 2;
  const Index booms = std::max<Index>(1, static_cast<Index>(s.cables().size() + 2 * s.beams().size()));
  return {elements, std::clamp<Index>(coordinates / (2 * elements * booms), 6, 12)};
}

SpacecraftResponse::SpacecraftResponse(const Spacecraft& s, const State& initial, const std::vector<Force>& forces,
                                       const std::vector<BoomPoint>& points)
    : SpacecraftResponse(s, initial, forces, points, mesh_for(s)) {}

SpacecraftResponse::SpacecraftResponse(const Spacecraft& s, const State& initial, const std::vector<Force>& forces,
                                       const std::vector<BoomPoint>& points, const Mesh& mesh)
    : SpacecraftResponse(s, Setup(s, initial, forces, mesh), points, mesh) {}

SpacecraftResponse::SpacecraftResponse(const Spacecraft& s, const Setup& setup, const std::vector<BoomPoint>& points, const Mesh& mesh)
    : mesh_(mesh),
      labels_(s.labels()),
      outputs_(output_map(s, mesh, setup.twin, points)),
      about_centre_(setup.twin.system, setup.about, setup.on_twin),
      centre_(setup.centre, setup.of_centre, setup.on_centre) {
  for (const BoomPoint& p : points) {
    for (const char* axis : {".x", ".y", ".z"}) labels_.push_back(p.name() + axis);
  }
  for (ModalShare m : about_centre_.modal()) {
    const ComplexVector seen = outputs_ * m.shape;
    if (seen.norm() > 0) {
      const Complex factor = std::polar(m.amplitude, m.phase) * largest_entry(seen);
      m.amplitude = std::abs(factor);
      m.phase = m.amplitude > 0 ? std::arg(factor) : 0;
      m.shape = normalised(seen);
    } else {
      m.amplitude = 0;
      m.shape = seen;
    }
    modal_.push_back(std::move(m));
  }
}

State SpacecraftResponse::at(double t) const {
  const State about = about_centre_.at(t), centre = centre_.at(t);
  State w{outputs_ * about.q, outputs_ * about.qdot};
  for (Index row = 0; row < w.q.size(); row += 3) {
    if (row == 3) continue;  // θ
    w.q.segment<3>(row) += centre.q;
    w.qdot.segment<3>(row) += centre.qdot;
  }
  return w;
}

History SpacecraftResponse::at(const Vector& times, const Progress& progress) const {
  return history_of(*this, outputs_.rows(), times, progress);
}

}  // namespace gyromode
