#include "gyromode/models/structure_mesh.h"

#include "gyromode/base/error.h"
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

// ‖y‖ of y = Kx − what it should be, relative to |x|ᵀ|K||x|, of every column.
Vector departures(const SparseMatrix& k, const Matrix& x, const Matrix& y) {
  const Vector diagonal = k.diagonal().cwiseAbs().cwiseMax(1e-300), sizes = sparse::sizes_of(k, x.cwiseAbs());
  Vector all(x.cols());
  for (Index j = 0; j < x.cols(); ++j) all(j) = std::sqrt(y.col(j).cwiseAbs2().cwiseQuotient(diagonal).sum() / std::max(sizes(j), 1e-300));
  return all;
}

constexpr double rounding_of_file = 1e-11;

// Translations T across the axis, where nothing holds them: KT = −Ω²MT to rounding. Of directions across the axis the
// first is along a coordinate, if one is.
Matrix free_translations(const StructureParts& p) {
  constexpr double across = 1e-9;
  const Eigen::Vector3d axis = Eigen::Vector3d(p.axis[0], p.axis[1], p.axis[2]).normalized();
  Eigen::Vector3d first = axis.unitOrthogonal();
  for (int d = 2; d >= 0; --d) {
    if (std::abs(axis(d)) <= across) first = Eigen::Vector3d::Unit(d);
  }
  const Eigen::Vector3d second = axis.cross(first);
  Matrix t(p.mass.cols(), 2);
  for (Index k = 0; k < t.rows(); ++k) {
    const int d = p.coordinates[static_cast<std::size_t>(k)].direction;
    t.row(k) << first(d), second(d);
  }
  const Matrix held = sparse::symmetric_times(p.stiffness, t) + p.spin * p.spin * sparse::symmetric_times(p.mass, t);
  return departures(p.stiffness, t, held).maxCoeff() > rounding_of_file ? Matrix(t.rows(), 0) : t;
}

// Along the axis, and where positions are known about it through the centre of mass: those that K takes to zero.
Matrix free_along_axis(const StructureParts& p) {
  const Eigen::Vector3d axis = Eigen::Vector3d(p.axis[0], p.axis[1], p.axis[2]).normalized();
  const auto centre = p.positions.empty() ? std::nullopt : facts_of(p).centre;
  const Eigen::Vector3d middle =
      centre ? Eigen::Vector3d((*centre)[0], (*centre)[1], (*centre)[2]) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  Matrix r = Matrix::Zero(p.mass.cols(), centre ? 2 : 1);
  for (Index k = 0; k < r.rows(); ++k) {
    const int d = p.coordinates[static_cast<std::size_t>(k)].direction;
    r(k, 0) = axis(d);
    if (!centre) continue;
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    r(k, 1) = axis.cross(Eigen::Vector3d(at[0], at[1], at[2]) - middle)(d);
  }
  const Vector off = departures(p.stiffness, r, sparse::symmetric_times(p.stiffness, r));
  std::vector<Index> there;
  for (Index k = 0; k < r.cols(); ++k) {
    if (r.col(k).squaredNorm() > 0 && off(k) <= rounding_of_file) there.push_back(k);
  }
  return r(Eigen::all, there);
}

}  // namespace

SparseMatrices assembled(const StructureParts& p) {
  const Index n = p.mass.cols();
  if (static_cast<Index>(p.coordinates.size()) != n || p.stiffness.cols() != n)
    throw LawBroken(fmt::format("mass of order {}, stiffness of order {} and {} coordinates: they must agree", n, p.stiffness.cols(),
                                p.coordinates.size()));
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

namespace {

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
  f.nodes = static_cast<Index>(Nodes(p.coordinates).number.size());
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
