#include "gyromode/models/mesh_symmetry.h"

#include "gyromode/base/error.h"
#include "gyromode/sparse/basis.h"
#include "gyromode/sparse/matrix.h"
#include "gyromode/sparse/partition.h"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace gyromode {

namespace {

constexpr double position_rounding = 1e-6;  // of the size of the mesh
constexpr double entry_rounding = 1e-11;    // of an entry, relative

using Eigen::Vector3d;

Vector3d vector_of(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }

// The axis that a direction is along, to rounding.
std::optional<int> coordinate_axis(const Vector3d& direction) {
  constexpr double along = 1e-12;
  for (int d = 0; d < 3; ++d) {
    if (1 - std::abs(direction(d)) <= along) return d;
  }
  return std::nullopt;
}

// Nodes by where they are, to a tolerance.
class Places {
 public:
  Places(const std::vector<Vector3d>& at, double tolerance) : at_(at), tolerance_(tolerance) {
    for (std::size_t k = 0; k < at.size(); ++k) cells_.emplace(key(cell(at[k], 0), cell(at[k], 1), cell(at[k], 2)), static_cast<int>(k));
  }

  // The node nearest to a place; −1 where none is within the tolerance.
  int find(const Vector3d& p) const {
    int best = -1;
    double least = tolerance_;
    for (long i = -1; i <= 1; ++i) {
      for (long j = -1; j <= 1; ++j) {
        for (long k = -1; k <= 1; ++k) {
          const auto [first, last] = cells_.equal_range(key(cell(p, 0) + i, cell(p, 1) + j, cell(p, 2) + k));
          for (auto it = first; it != last; ++it) {
            const double off = (at_[static_cast<std::size_t>(it->second)] - p).norm();
            if (off <= least) {
              least = off;
              best = it->second;
            }
          }
        }
      }
    }
    return best;
  }

 private:
  long cell(const Vector3d& p, int d) const { return std::lround(p(d) / (2 * tolerance_)); }
  static std::uint64_t key(long i, long j, long k) {
    constexpr std::uint64_t a = 0x9e3779b97f4a7c15ULL, b = 0xc2b2ae3d27d4eb4fULL, c = 0x165667b19e3779f9ULL;
    return static_cast<std::uint64_t>(i) * a ^ static_cast<std::uint64_t>(j) * b ^ static_cast<std::uint64_t>(k) * c;
  }

  const std::vector<Vector3d>& at_;
  double tolerance_;
  std::unordered_multimap<std::uint64_t, int> cells_;
};

struct PlacedNodes {
  std::vector<long> number;
  std::vector<Vector3d> at;
  std::vector<std::array<Index, 3>> coordinates;
};

PlacedNodes placed_nodes(const StructureParts& p) {
  PlacedNodes nodes;
  std::unordered_map<long, std::size_t> known;
  for (std::size_t k = 0; k < p.coordinates.size(); ++k) {
    const auto [it, fresh] = known.try_emplace(p.coordinates[k].node, nodes.number.size());
    if (fresh) {
      nodes.number.push_back(p.coordinates[k].node);
      nodes.at.push_back(vector_of(p.positions[k]));
      nodes.coordinates.push_back({-1, -1, -1});
    }
    nodes.coordinates[it->second][static_cast<std::size_t>(p.coordinates[k].direction)] = static_cast<Index>(k);
  }
  return nodes;
}

// Directions that a symmetry along coordinate axis d reverses: a mirror that one, a half-turn the two others.
std::array<bool, 3> reversed_by(MeshSymmetry::Kind kind, int d) {
  std::array<bool, 3> r{};
  for (int i = 0; i < 3; ++i) r[static_cast<std::size_t>(i)] = (i == d) == (kind == MeshSymmetry::Kind::mirror);
  return r;
}

// The image of every coordinate; why there is none goes to `why`.
std::optional<sparse::Involution> images(const PlacedNodes& nodes, const std::array<bool, 3>& reversed, Index n, std::string& why) {
  Vector3d low = nodes.at.front(), high = low;
  for (const Vector3d& p : nodes.at) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Vector3d middle = 0.5 * (low + high);
  const Places places(nodes.at, position_rounding * std::max((high - low).norm(), 1e-300));
  sparse::Involution s;
  s.partner.assign(static_cast<std::size_t>(n), 0);
  s.sign.assign(static_cast<std::size_t>(n), 1);
  for (std::size_t k = 0; k < nodes.at.size(); ++k) {
    Vector3d image = nodes.at[k];
    for (int d = 0; d < 3; ++d) {
      if (reversed[static_cast<std::size_t>(d)]) image(d) = 2 * middle(d) - image(d);
    }
    const int other = places.find(image);
    if (other < 0) {
      why = fmt::format("node {} at ({:.6g}, {:.6g}, {:.6g}) has no image: none is at ({:.6g}, {:.6g}, {:.6g})", nodes.number[k],
                        nodes.at[k](0), nodes.at[k](1), nodes.at[k](2), image(0), image(1), image(2));
      return std::nullopt;
    }
    for (std::size_t d = 0; d < 3; ++d) {
      const Index a = nodes.coordinates[k][d], b = nodes.coordinates[static_cast<std::size_t>(other)][d];
      if ((a < 0) != (b < 0)) {
        why = fmt::format("of node {} and its image, node {}, one keeps {} and the other does not", nodes.number[k],
                          nodes.number[static_cast<std::size_t>(other)], "xyz"[d]);
        return std::nullopt;
      }
      if (a < 0) continue;
      s.partner[static_cast<std::size_t>(a)] = b;
      s.sign[static_cast<std::size_t>(a)] = reversed[d] ? -1 : 1;
    }
  }
  for (std::size_t i = 0; i < s.partner.size(); ++i) {
    if (s.partner[static_cast<std::size_t>(s.partner[i])] != static_cast<Index>(i)) {
      why = "two nodes at one place have the same image";
      return std::nullopt;
    }
  }
  return s;
}

std::optional<FoundSymmetry> tried(const StructureParts& p, const SparseMatrices& m, const PlacedNodes& nodes, const MeshSymmetry& symmetry,
                                   int d, std::string& why) {
  auto s = images(nodes, reversed_by(symmetry.kind, d), m.mass.cols(), why);
  if (!s) return std::nullopt;
  const sparse::Departure off = sparse::departure_of(m, *s);
  if (off.largest > entry_rounding) {
    const auto name = [&](Index k) {
      const MeshCoordinate& c = p.coordinates[static_cast<std::size_t>(k)];
      return fmt::format("{}.{}", c.node, c.direction + 1);
    };
    why = fmt::format("{} differs from its image by {:.3g} of itself between coordinates {} and {}", off.matrix, off.largest, name(off.row),
                      name(off.column));
    return std::nullopt;
  }
  return FoundSymmetry{symmetry, std::move(*s), off.largest};
}

}  // namespace

std::string in_words(const MeshSymmetry& s) {
  const Vector3d d = vector_of(s.direction).normalized();
  const auto axis = coordinate_axis(d);
  const std::string along = axis ? std::string(1, "xyz"[*axis]) : fmt::format("({:.6g}, {:.6g}, {:.6g})", d(0), d(1), d(2));
  return s.kind == MeshSymmetry::Kind::mirror ? fmt::format("mirror plane with normal {}, through the axis of the spin", along)
                                              : fmt::format("half-turn about {}, across the axis of the spin", along);
}

std::optional<FoundSymmetry> symmetry_of(const StructureParts& p, const SparseMatrices& m) {
  if (p.positions.empty()) {
    if (p.symmetry)
      throw LawBroken(
          "a mirror plane or a half-turn needs the positions of the nodes: give coordinates = \"job.inp\" or a table node,x,y,z");
    return std::nullopt;
  }
  const Vector3d spin = vector_of(p.axis).normalized();
  const PlacedNodes nodes = placed_nodes(p);
  std::string why;
  constexpr double across = 1e-9;
  if (p.symmetry) {
    const Vector3d d = vector_of(p.symmetry->direction);
    if (!d.allFinite() || !(d.norm() > 0)) throw LawBroken(fmt::format("the direction of a symmetry must be three numbers, not all zero"));
    if (std::abs(d.normalized().dot(spin)) > across)
      throw LawBroken(fmt::format("{} does not reverse the spin: its direction must be across the axis", in_words(*p.symmetry)));
    const auto axis = coordinate_axis(d.normalized());
    auto found = axis ? tried(p, m, nodes, *p.symmetry, *axis, why) : std::nullopt;
    if (!found) throw LawBroken(fmt::format("{} is no symmetry of the mesh: {}", in_words(*p.symmetry), why));
    return found;
  }
  for (const auto kind : {MeshSymmetry::Kind::mirror, MeshSymmetry::Kind::half_turn}) {
    for (int d = 0; d < 3; ++d) {
      MeshSymmetry s{kind, {}};
      s.direction[static_cast<std::size_t>(d)] = 1;
      if (std::abs(spin(d)) > across) continue;
      if (auto found = tried(p, m, nodes, s, d, why)) return found;
    }
  }
  return std::nullopt;
}

namespace {

Eigen::Matrix3d columns_of(const std::array<std::array<double, 3>, 3>& turn) {
  Eigen::Matrix3d r;  // u = r w
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) r(i, j) = turn[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)];
  }
  return r;
}

// What turned axes do to the coordinates.
SparseMatrix turn_of(const StructureParts& p, const std::array<std::array<double, 3>, 3>& turn) {
  const Eigen::Matrix3d r = columns_of(turn);
  const auto n = static_cast<Index>(p.coordinates.size());
  std::map<std::pair<long, int>, Index> at;
  for (Index k = 0; k < n; ++k) {
    const MeshCoordinate& c = p.coordinates[static_cast<std::size_t>(k)];
    at[{c.node, c.direction}] = k;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (Index k = 0; k < n; ++k) {
    const MeshCoordinate& c = p.coordinates[static_cast<std::size_t>(k)];
    for (int j = 0; j < 3; ++j) {
      if (r(c.direction, j) == 0) continue;
      const auto other = at.find({c.node, j});
      if (other == at.end())
        throw LawBroken(fmt::format("node {} keeps {} and not {}: a symmetry that is along none of x, y, z mixes them", c.node,
                                    "xyz"[c.direction], "xyz"[j]));
      entries.emplace_back(static_cast<int>(k), static_cast<int>(other->second), r(c.direction, j));
    }
  }
  SparseMatrix q(n, n);
  q.setFromTriplets(entries.begin(), entries.end());
  return q;
}

}  // namespace

StructureParts turned(const StructureParts& p, const std::array<std::array<double, 3>, 3>& turn) {
  const Eigen::Matrix3d r = columns_of(turn);
  const SparseMatrix q = turn_of(p, turn);
  StructureParts t = p;
  for (SparseMatrix* a : {&t.mass, &t.stiffness, &t.stiffness_at_rest}) {
    if (a->cols() == 0) continue;
    const SparseMatrix full = a->selfadjointView<Eigen::Lower>();
    const SparseMatrix product = SparseMatrix(q.transpose()) * SparseMatrix(full * q);
    *a = SparseMatrix(product.triangularView<Eigen::Lower>());
  }
  const auto in_new = [&](const std::array<double, 3>& a) {
    const Vector3d v = r.transpose() * vector_of(a);
    return std::array<double, 3>{v(0), v(1), v(2)};
  };
  t.axis = in_new(p.axis);
  for (auto& x : t.positions) x = in_new(x);
  if (t.symmetry) t.symmetry->direction = in_new(t.symmetry->direction);
  return t;
}

namespace {

// Axes along the symmetry asked for, where it is along none of the coordinate axes: it becomes x.
std::optional<std::array<std::array<double, 3>, 3>> turn_for(const StructureParts& p) {
  if (!p.symmetry || p.positions.empty()) return std::nullopt;
  const Vector3d d = vector_of(p.symmetry->direction).normalized(), spin = vector_of(p.axis).normalized();
  if (!d.allFinite() || coordinate_axis(d)) return std::nullopt;
  const Vector3d other = spin.cross(d);
  std::array<std::array<double, 3>, 3> turn{};
  int at = 0;
  for (const Vector3d& v : {d, other, spin}) turn[static_cast<std::size_t>(at++)] = {v(0), v(1), v(2)};
  // Rounding of directions that are 0 would mix what is not to be mixed.
  for (auto& axis : turn) {
    for (double& x : axis) {
      if (std::abs(x) < 1e-15) x = 0;
    }
  }
  return turn;
}

}  // namespace

SparseMatrices in_symmetric_coordinates(const StructureParts& given) {
  SparseMatrices m = assembled(given);
  sparse::Basis b;
  b.given = sparse::analyse(m);
  if (!given.symmetry && b.given.system_class() != SystemClass::general) return m;
  const auto turn = turn_for(given);
  const StructureParts parts = turn ? turned(given, *turn) : given;
  b.norm_m = sparse::norm1(m.mass);
  b.norm_g = sparse::norm1(m.gyroscopic);
  b.norm_k = sparse::norm1(m.stiffness);
  Labels labels = m.labels;
  if (turn) m = assembled(parts);
  auto found = symmetry_of(parts, m);
  if (!found || b.given.system_class() != SystemClass::general) {
    if (turn) return assembled(given);
    return m;
  }
  if (turn) b.turn = turn_of(given, *turn);
  b.departure = found->departure;
  b.in_words = in_words(given.symmetry ? *given.symmetry : found->symmetry);
  for (Component& c : b.given.components) c.mesh_symmetry = true;
  SparseMatrices f = sparse::folded(m, found->of_coordinates);
  b.fold = std::move(found->of_coordinates);
  f.labels = std::move(labels);
  f.basis = std::make_shared<const sparse::Basis>(std::move(b));
  return f;
}

}  // namespace gyromode
