#include "gyromode/elements/boom_point.h"

#include "gyromode/base/error.h"
#include "gyromode/elements/elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

Index position(const System& twin, const std::string& label) {
  const auto at = std::find(twin.labels().begin(), twin.labels().end(), label);
  if (at == twin.labels().end()) throw InvalidArgument("the twin has no coordinate " + label);
  return at - twin.labels().begin();
}

template <class Parts>
const auto& part(const Parts& parts, Index number) {
  return parts[static_cast<std::size_t>(number - 1)];
}

// Which element, and where in it.
struct Place {
  Index element;
  double at;
};
Place place_in(double along, Index elements) {
  const double x = along * static_cast<double>(elements);
  const Index element = std::min<Index>(static_cast<Index>(x), elements - 1);
  return {element, x - static_cast<double>(element)};
}

void add_cable_point(const Cable& c, const Mesh& mesh, const System& twin, const BoomPoint& p, Matrix& map) {
  const auto [element, at] = place_in(p.along, mesh.elements);
  const Vector shape = lagrange_shape(mesh.degree, at);
  const Eigen::Vector3d out = c.direction(), tangent(-out(1), out(0), 0);
  for (Index i = 0; i <= mesh.degree; ++i) {
    const Index node = element * mesh.degree + i;
    if (node == 0) continue;  // the root
    map.col(position(twin, fmt::format("cable{}.across{}", p.number, node))) += shape(i) * tangent;
    map(2, position(twin, fmt::format("cable{}.axial{}", p.number, node))) += shape(i);
  }
}

void add_beam_point(const Beam& b, const Mesh& mesh, const System& twin, const BoomPoint& p, Matrix& map) {
  const Index elements = mesh.elements * mesh.degree;
  const auto [element, at] = place_in(p.along, elements);
  const Eigen::Vector4d shape = hermite_shape(b.length / static_cast<double>(elements), at);
  for (int plane = 0; plane < 2; ++plane) {
    for (Index i = 0; i < 4; ++i) {
      const Index node = element + i / 2;
      if (node == 0) continue;
      map(plane, position(twin, fmt::format("beam{}.{}{}.{}", p.number, i % 2 == 0 ? "u" : "slope", plane + 1, node))) += shape(i);
    }
  }
}

}  // namespace

void require_point(const Spacecraft& s, const BoomPoint& p) {
  const std::size_t count = p.part == BoomPoint::Part::cable  ? s.cables().size()
                            : p.part == BoomPoint::Part::beam ? s.beams().size()
                                                              : s.masses().size();
  if (p.number < 1 || static_cast<std::size_t>(p.number) > count)
    throw InvalidArgument(fmt::format("{}: the spacecraft has {} of that kind", p.name(), count));
  if (!(p.along >= 0 && p.along <= 1)) throw InvalidArgument(fmt::format("{}: a place from 0 (root) to 1 (tip) was expected", p.name()));
}

Eigen::Vector3d steady_place(const Spacecraft& s, const BoomPoint& p) {
  const Eigen::Vector3d centre(0, 0, s.centre());
  if (p.part == BoomPoint::Part::mass) return part(s.masses(), p.number).position - centre;
  if (p.part == BoomPoint::Part::beam) {
    const Beam& b = part(s.beams(), p.number);
    return Eigen::Vector3d(0, 0, b.root_height + b.way() * b.length * p.along) - centre;
  }
  const Cable& c = part(s.cables(), p.number);
  return (c.radius + c.length * p.along) * c.direction() + Eigen::Vector3d(0, 0, c.height) - centre;
}

Matrix relative_displacement(const Spacecraft& s, const Mesh& mesh, const System& twin, const BoomPoint& p) {
  require_point(s, p);
  Matrix map = Matrix::Zero(3, twin.size());
  if (p.part == BoomPoint::Part::cable) add_cable_point(part(s.cables(), p.number), mesh, twin, p, map);
  if (p.part == BoomPoint::Part::beam) add_beam_point(part(s.beams(), p.number), mesh, twin, p, map);
  if (p.part == BoomPoint::Part::mass) {
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(part(s.masses(), p.number).stiffness(axis)))
        map(axis, position(twin, fmt::format("mass{}.u{}", p.number, axis + 1))) = 1;
    }
  }
  return map;
}

}  // namespace gyromode
