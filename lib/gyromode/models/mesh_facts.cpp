#include "gyromode/models/structure_mesh.h"
#include "gyromode/sparse/matrix.h"

#include <Eigen/Geometry>

#include <unordered_set>

namespace gyromode {

namespace {

Index number_of_nodes(const std::vector<MeshCoordinate>& coordinates) {
  std::unordered_set<long> all;
  for (const MeshCoordinate& c : coordinates) all.insert(c.node);
  return static_cast<Index>(all.size());
}

// p_d of the centre is 1ᵀM p_d / 1ᵀM1 over the coordinates of one direction.
void place(const StructureParts& p, MeshFacts& f) {
  const auto n = static_cast<Index>(p.coordinates.size());
  std::size_t fullest = 0;
  for (std::size_t d = 1; d < 3; ++d) fullest = f.mass_per_direction[d] > f.mass_per_direction[fullest] ? d : fullest;
  Matrix along = Matrix::Zero(n, 4);  // 1 and the three coordinates of the position
  for (Index k = 0; k < n; ++k) {
    if (static_cast<std::size_t>(p.coordinates[static_cast<std::size_t>(k)].direction) != fullest) continue;
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    along.row(k) << 1, at[0], at[1], at[2];
  }
  const Vector m = sparse::symmetric_times(p.mass, along.col(0));
  const double mass = m.dot(along.col(0));
  if (!(mass > 0)) return;
  const Eigen::Vector3d c = along.rightCols(3).transpose() * m / mass;
  f.centre = {c(0), c(1), c(2)};
  Matrix turns(n, 3);
  for (Index k = 0; k < n; ++k) {
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    const Eigen::Vector3d arm = Eigen::Vector3d(at[0], at[1], at[2]) - c;
    for (int e = 0; e < 3; ++e) turns(k, e) = Eigen::Vector3d::Unit(e).cross(arm)(p.coordinates[static_cast<std::size_t>(k)].direction);
  }
  const Matrix i = turns.transpose() * sparse::symmetric_times(p.mass, turns);
  f.inertia = {i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(1, 2), i(2, 0)};
}

}  // namespace

// 1ᵀM1 over the coordinates of a direction.
MeshFacts facts_of(const StructureParts& p) {
  MeshFacts f;
  f.nodes = number_of_nodes(p.coordinates);
  for (Index q = 0; q < p.mass.outerSize(); ++q) {
    for (SparseMatrix::InnerIterator it(p.mass, q); it; ++it) {
      const int a = p.coordinates[static_cast<std::size_t>(it.row())].direction, b = p.coordinates[static_cast<std::size_t>(q)].direction;
      if (a == b) f.mass_per_direction[static_cast<std::size_t>(a)] += (it.row() == q ? 1 : 2) * it.value();
    }
  }
  if (!p.positions.empty()) place(p, f);
  return f;
}

}  // namespace gyromode
