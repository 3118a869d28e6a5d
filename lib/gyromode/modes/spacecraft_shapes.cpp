#include "gyromode/modes/spacecraft_shapes.h"

#include "gyromode/base/rounding.h"
#include "gyromode/modes/shape.h"

namespace gyromode {

namespace {

Complex largest_displacement(const std::vector<ComplexMatrix>& field) {
  Complex largest = 0;
  for (const ComplexMatrix& line : field) {
    for (const Complex& z : line.reshaped()) {
      if (std::abs(z) > std::abs(largest)) largest = z;
    }
  }
  return largest == 0.0 ? 1 : largest;
}

// θ × p (Eigen's cross() conjugates complex vectors).
Eigen::Vector3cd rotated(const Eigen::Vector3cd& theta, const Eigen::Vector3d& p) {
  return {theta(1) * p(2) - theta(2) * p(1), theta(2) * p(0) - theta(0) * p(2), theta(0) * p(1) - theta(1) * p(0)};
}

ComplexVector body_shape(const SpacecraftSpectrum& s, const Root& r) {
  if (body_at_rest(r)) return ComplexVector::Zero(6);
  if (!r.rigid) return s.impedance().body_motion(r.omega, r.vector);
  ComplexVector tilt = ComplexVector::Zero(6);
  tilt(3) = 1;
  tilt(4) = Complex(0, 1);
  return tilt;
}

// Displacement ζ + θ × p of every point, and what its appendage adds; in the tilt none adds any.
std::vector<ComplexMatrix> field_of(const SpacecraftSpectrum& s, const Root& r, const ComplexVector& q) {
  const double length = s.impedance().unit_length();
  std::vector<ComplexMatrix> all;
  for (const auto& part : s.impedance().parts()) {
    std::vector<ComplexMatrix> relative;
    if (!r.rigid) {
      relative = part.appendage->displaced(r.omega, s.impedance().body_vector(r.omega, r.vector),
                                           r.vector.segment(part.first, part.appendage->coordinates()));
    }
    const std::vector<Outline> lines = part.appendage->outlines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ComplexMatrix d(3, static_cast<Index>(lines[i].points.size()));
      for (Index k = 0; k < d.cols(); ++k)
        d.col(k) = q.head<3>() + rotated(q.tail<3>(), length * lines[i].points[static_cast<std::size_t>(k)]);
      if (!relative.empty()) d += length * relative[i];
      all.push_back(std::move(d));
    }
  }
  return all;
}

}  // namespace

bool body_at_rest(const Root& r) { return r.vector.head<body_coordinates>().norm() <= 64 * epsilon * r.vector.norm(); }

void add_shape(const SpacecraftSpectrum& s, const Root& r, Mode& mode) {
  const ComplexVector q = body_shape(s, r);
  mode.field = field_of(s, r, q);
  mode.shape = normalised(q);
  const Complex scale = body_at_rest(r) ? largest_displacement(mode.field) : largest_entry(q);
  for (ComplexMatrix& line : mode.field) line /= scale;
}

std::vector<ModelOutline> outlines_of(const SpacecraftSpectrum& s) {
  std::vector<ModelOutline> all;
  for (const auto& part : s.impedance().parts()) {
    for (const Outline& o : part.appendage->outlines()) {
      ModelOutline line{o.name, {}};
      for (const Eigen::Vector3d& p : o.points)
        line.points.push_back(s.impedance().unit_length() * p + Eigen::Vector3d(0, 0, s.spacecraft().centre()));
      all.push_back(std::move(line));
    }
  }
  return all;
}

}  // namespace gyromode
