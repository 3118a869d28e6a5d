#include "gyromode/models/structure_mesh.h"

#include "gyromode/base/error.h"
#include "gyromode/models/mesh_free_motions.h"
#include "gyromode/sparse/matrix.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <cmath>
#include <unordered_map>

namespace gyromode {

namespace {

constexpr const char* letters[3] = {"x", "y", "z"};
constexpr double rounding = 1e-9;  // of the diagonal entries of two coordinates

std::string name_of(const MeshCoordinate& c) { return fmt::format("{}.{}", c.node, letters[c.direction]); }

// The coordinates of every node by direction, −1 for those it has not; nodes numbered from 0 as they come.
struct Nodes {
  std::vector<int> of;  // of every coordinate
  std::vector<std::array<int, 3>> coordinates;
  std::vector<long> number;

  explicit Nodes(const std::vector<MeshCoordinate>& all) {
    std::unordered_map<long, int> known;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const auto [at, fresh] = known.try_emplace(all[k].node, static_cast<int>(coordinates.size()));
      if (fresh) {
        coordinates.push_back({-1, -1, -1});
        number.push_back(all[k].node);
      }
      of.push_back(at->second);
      coordinates[static_cast<std::size_t>(at->second)][static_cast<std::size_t>(all[k].direction)] = static_cast<int>(k);
    }
  }
  const std::array<int, 3>& at(int node) const { return coordinates[static_cast<std::size_t>(node)]; }
};

// [a]×: (a × v)_i = Σ_j cross(i, j) v_j.
Eigen::Matrix3d cross_of(const std::array<double, 3>& axis) {
  const Eigen::Vector3d given(axis[0], axis[1], axis[2]);
  if (!given.allFinite() || !(given.norm() > 0)) throw LawBroken("the axis of the spin must have a direction: three numbers, not all zero");
  const Eigen::Vector3d a = given.normalized();
  Eigen::Matrix3d c;
  c << 0, -a(2), a(1), a(2), 0, -a(0), -a(1), a(0), 0;
  return c;
}

// Nodes that share no direction: the mass between them is in no entry of M, and G needs it.
void require_shared_directions(const Nodes& nodes, const Eigen::Matrix3d& cross) {
  std::array<int, 8> example{};
  example.fill(-1);
  for (std::size_t k = 0; k < nodes.coordinates.size(); ++k) {
    const auto& c = nodes.coordinates[k];
    example[static_cast<std::size_t>((c[0] >= 0) + 2 * (c[1] >= 0) + 4 * (c[2] >= 0))] = static_cast<int>(k);
  }
  for (unsigned a = 1; a < 8; ++a) {
    for (unsigned b = 1; b < 8; ++b) {
      if (example[a] < 0 || example[b] < 0 || (a & b) != 0) continue;
      for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
          if ((a >> i & 1U) == 0 || (b >> j & 1U) == 0 || cross(i, j) == 0) continue;
          throw LawBroken(
              fmt::format("node {} keeps {} and node {} keeps {}, and no direction is kept by both: the mass between such nodes is "
                          "not in the file, and Coriolis forces need it; let them keep one direction in common",
                          nodes.number[static_cast<std::size_t>(example[a])], letters[i],
                          nodes.number[static_cast<std::size_t>(example[b])], letters[j]));
        }
      }
    }
  }
}

}  // namespace

SparseMatrix stiffness_per_spin2(const StructureParts& p) { return (p.stiffness - p.stiffness_at_rest) / (p.spin * p.spin); }

StructureParts at_spin(const StructureParts& parts, double spin) {
  StructureParts p = parts;
  const double share = spin / parts.spin * (spin / parts.spin);
  if (spin != parts.spin) p.stiffness = SparseMatrix(share * parts.stiffness + (1 - share) * parts.stiffness_at_rest);
  p.spin = spin;
  if (spin == 0) p.stiffness_at_rest.resize(0, 0);
  return p;
}

SparseMatrices assembled(const StructureParts& p) {
  const Index n = p.mass.cols();
  if (static_cast<Index>(p.coordinates.size()) != n || p.stiffness.cols() != n)
    throw LawBroken(fmt::format("mass of order {}, stiffness of order {} and {} coordinates: they must agree", n, p.stiffness.cols(),
                                p.coordinates.size()));
  if (p.stiffness_at_rest.cols() > 0 && p.stiffness_at_rest.cols() != n)
    throw LawBroken(fmt::format("stiffness at rest of order {}, mass of order {}: they must agree", p.stiffness_at_rest.cols(), n));
  const Nodes nodes(p.coordinates);
  const Eigen::Matrix3d cross = cross_of(p.axis);
  if (p.spin != 0) require_shared_directions(nodes, cross);
  const Vector diagonal = p.mass.diagonal();
  std::vector<Eigen::Triplet<double>> g;
  for (Index q = 0; q < n; ++q) {
    for (SparseMatrix::InnerIterator it(p.mass, q); it; ++it) {
      const Index r = it.row();
      const MeshCoordinate &a = p.coordinates[static_cast<std::size_t>(r)], &b = p.coordinates[static_cast<std::size_t>(q)];
      const double m = it.value();
      if (m == 0) continue;
      const double size = std::sqrt(std::abs(diagonal(r) * diagonal(q)));
      if (a.direction != b.direction) {
        if (std::abs(m) <= rounding * size) continue;
        throw LawBroken(
            fmt::format("mass couples {} and {}: Coriolis forces are made of mass that is the same in all directions and couples "
                        "none, as that of displacements of nodes; give G by its own file instead",
                        name_of(a), name_of(b)));
      }
      const auto &of_a = nodes.at(nodes.of[static_cast<std::size_t>(r)]), &of_b = nodes.at(nodes.of[static_cast<std::size_t>(q)]);
      std::size_t first = 0;  // direction that both nodes have: the pair is taken once
      while (first < 3 && (of_a[first] < 0 || of_b[first] < 0)) ++first;
      if (static_cast<std::size_t>(a.direction) != first) {
        const double other = p.mass.coeff(std::max(of_a[first], of_b[first]), std::min(of_a[first], of_b[first]));
        if (std::abs(other - m) > rounding * size)
          throw LawBroken(
              fmt::format("mass between nodes {} and {} is {:.6g} along {} and {:.6g} along {}: Coriolis forces are made of mass that "
                          "is the same in all directions",
                          a.node, b.node, other, letters[first], m, letters[a.direction]));
        continue;
      }
      if (p.spin == 0) continue;
      const bool same = &of_a == &of_b;
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
          const double value = 2 * p.spin * m * cross(static_cast<Index>(i), static_cast<Index>(j));
          if (value == 0) continue;
          const auto add = [&](int row, int column) {  // G = −Gᵀ: what is above the diagonal has its mirror image below
            if (row >= 0 && column >= 0 && row > column) g.emplace_back(row, column, value);
          };
          add(of_a[i], of_b[j]);
          if (!same) add(of_b[i], of_a[j]);
        }
      }
    }
  }
  SparseMatrices all;
  all.gyroscopic.resize(n, n);
  all.gyroscopic.setFromTriplets(g.begin(), g.end());
  // Where every node moves in all directions that the spin turns, or in none, G is 2Ω[a]× of a mass that M holds in
  // full.
  const bool whole = std::all_of(nodes.coordinates.begin(), nodes.coordinates.end(), [&](const auto& of) {
    int there = 0, turned = 0;
    for (Index d = 0; d < 3; ++d) {
      if (cross.row(d).squaredNorm() == 0) continue;
      ++turned;
      there += of[static_cast<std::size_t>(d)] >= 0 ? 1 : 0;
    }
    return there == 0 || there == turned;
  });
  constexpr double with_rounding = 1 + 1e-6;
  if (whole) all.gyroscopic_bound = 2 * std::abs(p.spin) * with_rounding;
  all.mass = p.mass;
  all.stiffness = p.stiffness;
  if (whole && p.spin != 0) all.translations = free_translations(p);
  all.rigid = free_along_axis(p);
  for (const MeshCoordinate& c : p.coordinates) all.labels.push_back(name_of(c));
  all.node = nodes.of;
  return all;
}

}  // namespace gyromode
