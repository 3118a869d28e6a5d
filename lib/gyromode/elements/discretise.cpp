#include "gyromode/elements/discretise.h"

#include "gyromode/elements/elements.h"
#include "gyromode/elements/quadratic_energy.h"
#include "gyromode/lapack/small.h"
#include "gyromode/system/laws.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gyromode {

namespace {

constexpr Index body = 6;  // ζ, θ

struct Numbering {
  Labels labels;
  Index take(std::string label) {
    labels.push_back(std::move(label));
    return body + static_cast<Index>(labels.size()) - 1;
  }
};

// Six mass points with the mass and inertia of the body.
void add_body(QuadraticEnergy& e, const Spacecraft& s) {
  const Eigen::Matrix3d second = MassProperties::body(s.body().mass, s.body().inertia).second;
  const auto axes = small::symmetric_eigen(second);
  const Eigen::Vector3d centre(0, 0, -s.centre());
  for (Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d arm = std::sqrt(std::max(0.0, 3 * axes.values(k) / s.body().mass)) * axes.vectors.col(k);
    e.add_point(s.body().mass / 6, centre + arm);
    e.add_point(s.body().mass / 6, centre - arm);
  }
}

// Nodes of a cable: the root is fixed (−1), then `degree` a element.
struct CableNodes {
  std::vector<Index> across, axial;
};

CableNodes number_cable(Numbering& n, Index cable, const Mesh& mesh) {
  CableNodes nodes{{-1}, {-1}};
  for (Index k = 1; k <= mesh.elements * mesh.degree; ++k) {
    nodes.across.push_back(n.take(fmt::format("cable{}.across{}", cable, k)));
    nodes.axial.push_back(n.take(fmt::format("cable{}.axial{}", cable, k)));
  }
  return nodes;
}

void add_cable(QuadraticEnergy& e, const Cable& c, double centre, double spin, const CableNodes& nodes, const Mesh& mesh) {
  const Eigen::Vector3d out = c.direction(), tangent(-out(1), out(0), 0), root(0, 0, c.height - centre);
  const LagrangeElement element(mesh.degree);
  const double h = c.length / static_cast<double>(mesh.elements);
  const auto point = [&](double mass, double s, Index first, const Vector& shape) {
    LinearForm u[3];
    for (Index k = 0; k < shape.size(); ++k) {
      const auto at = static_cast<std::size_t>(first + k);
      if (nodes.across[at] < 0 || shape(k) == 0) continue;
      u[0].add(nodes.across[at], tangent(0) * shape(k));
      u[1].add(nodes.across[at], tangent(1) * shape(k));
      u[2].add(nodes.axial[at], shape(k));
    }
    e.add_point(mass, root + (c.radius + s) * out, u);
  };
  for (Index k = 0; k < mesh.elements; ++k) {
    const Index first = k * mesh.degree;
    for (const auto& g : element.points()) {
      const double s = h * (static_cast<double>(k) + g.at);
      point(c.line_density * h * g.weight, s, first, g.shape);
      // Slopes draw in all mass beyond, against its centrifugal force: ½ T (v′² + w′²).
      const double r = c.radius + s;
      const double tension = spin * spin * (c.tip_mass * c.reach() + 0.5 * c.line_density * (c.reach() + r) * (c.reach() - r));
      for (const auto* line : {&nodes.across, &nodes.axial}) {
        LinearForm slope;
        for (Index i = 0; i < g.slope.size(); ++i) {
          const Index node = (*line)[static_cast<std::size_t>(first + i)];
          if (node >= 0) slope.add(node, g.slope(i) / h);
        }
        e.add_stiffness(tension * h * g.weight, slope);
      }
    }
  }
  Vector tip = Vector::Zero(mesh.degree + 1);
  tip(mesh.degree) = 1;
  if (c.tip_mass > 0) point(c.tip_mass, c.length, (mesh.elements - 1) * mesh.degree, tip);
}

void add_beam(QuadraticEnergy& e, const Beam& b, double centre, Numbering& n, Index beam, Index elements) {
  const double h = b.length / static_cast<double>(elements);
  // Displacement and slope of each node in both planes; the root is clamped.
  std::vector<std::array<Index, 2>> node[2];
  for (int plane = 0; plane < 2; ++plane) node[plane].push_back({-1, -1});
  for (Index k = 1; k <= elements; ++k) {
    for (int plane = 0; plane < 2; ++plane) {
      node[plane].push_back(
          {n.take(fmt::format("beam{}.u{}.{}", beam, plane + 1, k)), n.take(fmt::format("beam{}.slope{}.{}", beam, plane + 1, k))});
    }
  }
  const auto form = [&](int plane, Index k, const Eigen::Vector4d& shape) {
    LinearForm f;
    for (Index i = 0; i < 4; ++i) {
      const Index at = node[plane][static_cast<std::size_t>(k + i / 2)][static_cast<std::size_t>(i % 2)];
      if (at >= 0) f.add(at, shape(i));
    }
    return f;
  };
  for (Index k = 0; k < elements; ++k) {
    for (const auto& g : hermite_points(h)) {
      const double s = h * (static_cast<double>(k) + g.at);
      const LinearForm u[3] = {form(0, k, g.shape), form(1, k, g.shape), {}};
      e.add_point(b.line_density * h * g.weight, Eigen::Vector3d(0, 0, b.root_height - centre + b.way() * s), u);
      for (int plane = 0; plane < 2; ++plane) e.add_stiffness(b.bending_stiffness[plane] * h * g.weight, form(plane, k, g.curvature));
    }
  }
  const LinearForm tip[3] = {form(0, elements - 1, {0, 0, 1, 0}), form(1, elements - 1, {0, 0, 1, 0}), {}};
  if (b.tip_mass > 0) e.add_point(b.tip_mass, Eigen::Vector3d(0, 0, b.root_height - centre + b.way() * b.length), tip);
}

// Mass points and springs, with the coordinate of each sprung direction.
void add_masses(QuadraticEnergy& e, const Spacecraft& s, Numbering& n) {
  for (std::size_t i = 0; i < s.masses().size(); ++i) {
    const SpringMass& m = s.masses()[i];
    LinearForm u[3];
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(m.stiffness(axis))) continue;
      u[axis].add(n.take(fmt::format("mass{}.u{}", i + 1, axis + 1)), 1);
      e.add_stiffness(m.stiffness(axis), u[axis]);
    }
    e.add_point(m.mass, m.position - Eigen::Vector3d(0, 0, s.centre()), u);
  }
}

Index coordinates_of(const Spacecraft& s, const Mesh& mesh) {
  Index n = body + static_cast<Index>(s.cables().size()) * 2 * mesh.elements * mesh.degree +
            static_cast<Index>(s.beams().size()) * 4 * mesh.elements * mesh.degree;
  for (const SpringMass& m : s.masses()) n += m.stiffness.array().isFinite().count();
  require_order(fmt::format("the twin with {} elements a cable", mesh.elements), n);
  return n;
}

// ζ = −M_ζζ⁻¹ M_ζq q keeps the mass centre where it is; θ3 takes part in no stored energy.
Matrix without_translation(const Matrix& a, const Matrix& onto) {
  const Index n = a.rows() - 3;
  const Matrix cross = onto.transpose() * a.topRightCorner(3, n);
  return a.bottomRightCorner(n, n) + cross + (a.bottomLeftCorner(n, 3) * onto) + onto.transpose() * a.topLeftCorner<3, 3>() * onto;
}

}  // namespace

System discretise(const Spacecraft& s, const Mesh& mesh) { return twin_of(s, mesh).system; }

Twin twin_of(const Spacecraft& s, const Mesh& mesh) {
  QuadraticEnergy e(coordinates_of(s, mesh), s.spin());
  Numbering n;
  add_body(e, s);
  for (std::size_t i = 0; i < s.cables().size(); ++i) {
    const CableNodes nodes = number_cable(n, static_cast<Index>(i) + 1, mesh);
    add_cable(e, s.cables()[i], s.centre(), s.spin(), nodes, mesh);
  }
  for (std::size_t i = 0; i < s.beams().size(); ++i)
    add_beam(e, s.beams()[i], s.centre(), n, static_cast<Index>(i) + 1, mesh.elements * mesh.degree);
  add_masses(e, s, n);
  const Matrix onto = -e.mass().topRightCorner(3, e.mass().cols() - 3) / s.rigid().mass;
  Matrix m = without_translation(e.mass(), onto), g = without_translation(e.gyroscopic(), onto),
         k = without_translation(e.stiffness(), onto);
  k.row(2).setZero();
  k.col(2).setZero();
  Labels labels{"theta1", "theta2", "theta3"};
  labels.insert(labels.end(), n.labels.begin(), n.labels.end());
  return {System(symmetric_part(m), skew_part(g), symmetric_part(k), std::move(labels)), onto};
}

}  // namespace gyromode
