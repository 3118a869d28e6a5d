#include "gyromode/models/structure_mesh.h"
#include "gyromode/sparse/matrix.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <unordered_set>

namespace gyromode {

namespace {

Index number_of_nodes(const std::vector<MeshCoordinate>& coordinates) {
  std::unordered_set<long> all;
  for (const MeshCoordinate& c : coordinates) all.insert(c.node);
  return static_cast<Index>(all.size());
}

// 1ᵀM1 over the coordinates of a direction.
std::array<double, 3> masses_of(const StructureParts& p) {
  std::array<double, 3> mass{};
  for (Index q = 0; q < p.mass.outerSize(); ++q) {
    for (SparseMatrix::InnerIterator it(p.mass, q); it; ++it) {
      const int a = p.coordinates[static_cast<std::size_t>(it.row())].direction, b = p.coordinates[static_cast<std::size_t>(q)].direction;
      if (a == b) mass[static_cast<std::size_t>(a)] += (it.row() == q ? 1 : 2) * it.value();
    }
  }
  return mass;
}

// uᵀMu of the turns u = e × (p − centre).
std::array<double, 6> inertia_about(const std::array<double, 3>& centre, const StructureParts& p) {
  Matrix turns(static_cast<Index>(p.coordinates.size()), 3);
  for (Index k = 0; k < turns.rows(); ++k) {
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    const Eigen::Vector3d arm(at[0] - centre[0], at[1] - centre[1], at[2] - centre[2]);
    for (int e = 0; e < 3; ++e) turns(k, e) = Eigen::Vector3d::Unit(e).cross(arm)(p.coordinates[static_cast<std::size_t>(k)].direction);
  }
  const Matrix i = turns.transpose() * sparse::symmetric_times(p.mass, turns);
  return {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(1, 2), i(2, 0)};
}

}  // namespace

// p_d of the centre is 1ᵀM p_d / 1ᵀM1 over the coordinates of one direction, that of the most mass.
std::optional<std::array<double, 3>> centre_of(const StructureParts& p) {
  if (p.positions.empty()) return std::nullopt;
  const std::array<double, 3> masses = masses_of(p);
  const auto fullest = std::max_element(masses.begin(), masses.end()) - masses.begin();
  Matrix along = Matrix::Zero(static_cast<Index>(p.coordinates.size()), 4);  // 1 and the three coordinates of the position
  for (Index k = 0; k < along.rows(); ++k) {
    if (p.coordinates[static_cast<std::size_t>(k)].direction != fullest) continue;
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    along.row(k) << 1, at[0], at[1], at[2];
  }
  const Vector m = sparse::symmetric_times(p.mass, along.col(0));
  const double mass = m.dot(along.col(0));
  if (!(mass > 0)) return std::nullopt;
  const Eigen::Vector3d c = along.rightCols(3).transpose() * m / mass;
  return std::array<double, 3>{c(0), c(1), c(2)};
}

MeshFacts facts_of(const StructureParts& p) {
  MeshFacts f;
  f.nodes = number_of_nodes(p.coordinates);
  f.mass_per_direction = masses_of(p);
  f.centre = centre_of(p);
  if (f.centre) f.inertia = inertia_about(*f.centre, p);
  return f;
}

}  // namespace gyromode
