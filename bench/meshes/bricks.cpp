#include "meshes/bricks.h"

#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/node_order.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode::bench {

namespace {

constexpr std::array<std::array<int, 3>, 8> corner{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

using Element = Eigen::Matrix<double, 24, 24>;
using Scalar8 = Eigen::Matrix<double, 8, 8>;

Eigen::Matrix<double, 6, 6> elasticity(const Material& of) {
  const double shear = of.young / (2 * (1 + of.poisson)), lame = of.young * of.poisson / ((1 + of.poisson) * (1 - 2 * of.poisson));
  Eigen::Matrix<double, 6, 6> d = Eigen::Matrix<double, 6, 6>::Zero();
  d.topLeftCorner<3, 3>().setConstant(lame);
  for (int i = 0; i < 3; ++i) {
    d(i, i) += 2 * shear;
    d(i + 3, i + 3) = shear;
  }
  return d;
}

using Corners = std::array<std::array<double, 3>, 8>;

// A point of integration: its volume, the shape functions of the corners there, and their slopes.
struct Point {
  double volume = 0;
  Eigen::Matrix<double, 8, 1> shape;
  Eigen::Matrix<double, 8, 3> slope;

  Eigen::Matrix<double, 6, 24> strain() const {
    Eigen::Matrix<double, 6, 24> b = Eigen::Matrix<double, 6, 24>::Zero();
    for (int c = 0; c < 8; ++c) {
      const double bx = slope(c, 0), by = slope(c, 1), bz = slope(c, 2);
      b.block<6, 3>(0, 3 * c) << bx, 0, 0, 0, by, 0, 0, 0, bz, by, bx, 0, 0, bz, by, bz, 0, bx;
    }
    return b;
  }
};

std::array<Point, 8> points_of(const Corners& x) {
  std::array<Point, 8> all;
  const double at = 1 / std::sqrt(3.0);
  for (std::size_t n = 0; n < 8; ++n) {
    const auto& g = corner[n];
    Eigen::Matrix<double, 8, 3> slope;
    for (int c = 0; c < 8; ++c) {
      double f[3], s[3];
      for (int i = 0; i < 3; ++i) {
        const double sign = 2 * corner[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] - 1,
                     p = at * (2 * g[static_cast<std::size_t>(i)] - 1);
        f[i] = 0.5 * (1 + sign * p);
        s[i] = 0.5 * sign;
      }
      all[n].shape(c) = f[0] * f[1] * f[2];
      slope.row(c) << s[0] * f[1] * f[2], f[0] * s[1] * f[2], f[0] * f[1] * s[2];
    }
    Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 8; ++c) {
      const auto& p = x[static_cast<std::size_t>(c)];
      j += slope.row(c).transpose() * Eigen::RowVector3d(p[0], p[1], p[2]);
    }
    all[n].volume = std::abs(j.determinant());
    all[n].slope = slope * j.inverse().transpose();
  }
  return all;
}

void element(const Corners& x, const Material& of, Element& k, Scalar8& m) {
  const auto d = elasticity(of);
  k.setZero();
  m.setZero();
  for (const Point& p : points_of(x)) {
    k += p.volume * p.strain().transpose() * d * p.strain();
    m += of.density * p.volume * p.shape * p.shape.transpose();
  }
}

// ∫ ∇N σ ∇Nᵀ of the stress σ that the displacements u of the corners make.
Scalar8 stress_stiffness(const Corners& x, const Material& of, const Eigen::Matrix<double, 24, 1>& u) {
  const auto d = elasticity(of);
  Scalar8 k = Scalar8::Zero();
  for (const Point& p : points_of(x)) {
    const Eigen::Matrix<double, 6, 1> s = d * p.strain() * u;
    Eigen::Matrix3d stress;
    stress << s(0), s(3), s(5), s(3), s(1), s(4), s(5), s(4), s(2);
    k += p.volume * p.slope * stress * p.slope.transpose();
  }
  return k;
}

Corners corners_of(const BrickMesh& mesh, const std::array<int, 8>& brick) {
  Corners x{};
  for (std::size_t c = 0; c < 8; ++c) x[c] = mesh.nodes[static_cast<std::size_t>(brick[c])];
  return x;
}

}  // namespace

BrickMesh box(std::array<double, 3> size, std::array<int, 3> bricks, bool clamped) {
  BrickMesh m;
  const auto [nx, ny, nz] = bricks;
  const auto node = [&, ny = ny, nx = nx](int i, int j, int k) { return (k * (ny + 1) + j) * (nx + 1) + i; };
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        m.nodes.push_back({size[0] * (static_cast<double>(i) / nx - 0.5), size[1] * (static_cast<double>(j) / ny - 0.5), size[2] * k / nz});
        m.held.push_back(clamped && k == 0);
      }
    }
  }
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      for (int i = 0; i < nx; ++i) {
        std::array<int, 8> b{};
        for (std::size_t c = 0; c < 8; ++c) b[c] = node(i + corner[c][0], j + corner[c][1], k + corner[c][2]);
        m.bricks.push_back(b);
      }
    }
  }
  return m;
}

// The ring in cylinder coordinates, an even number of bricks for every blade around it; blades stand on the middle half
// of their share of the rim, as many bricks wide and thick.
BrickMesh bladed_disc(int blades, int fine, double twist, double lean) {
  BrickMesh m;
  const int around = blades * 4 * fine, deep = 4 * fine, high = 2 * fine, radial = 6 * fine, wide = 2 * fine;
  constexpr double inner = 1, outer = 2, length = 1.5, thickness = 0.3;
  const auto z_of = [&](int k) { return thickness * (static_cast<double>(k) / high - 0.5); };
  const auto ring = [&](int a, int r, int k) { return ((a % around) * (deep + 1) + r) * (high + 1) + k; };
  for (int a = 0; a < around; ++a) {
    // A blade is in the middle of its share, so that radii through blades are among the coordinate axes.
    const double angle = 2 * std::numbers::pi * (a - fine * 2) / around;
    for (int r = 0; r <= deep; ++r) {
      const double radius = inner + (outer - inner) * r / deep;
      for (int k = 0; k <= high; ++k) {
        m.nodes.push_back({radius * std::cos(angle), radius * std::sin(angle), z_of(k)});
        m.held.push_back(r == 0);
      }
    }
  }
  const auto add = [&](const auto& node, int a, int r, int k) {
    std::array<int, 8> b{};
    for (std::size_t c = 0; c < 8; ++c) b[c] = node(a + corner[c][0], r + corner[c][1], k + corner[c][2]);
    m.bricks.push_back(b);
  };
  for (int a = 0; a < around; ++a) {
    for (int r = 0; r < deep; ++r) {
      for (int k = 0; k < high; ++k) add(ring, a, r, k);
    }
  }
  for (int blade = 0; blade < blades; ++blade) {
    const int from = blade * 4 * fine + fine;
    const double middle = 2 * std::numbers::pi * blade / blades;
    const int first = static_cast<int>(m.nodes.size());
    for (int r = 1; r <= radial; ++r) {
      const double part = static_cast<double>(r) / radial, turn = twist * part;
      for (int a = 0; a <= wide; ++a) {
        const double angle = 2 * std::numbers::pi * (from + a - fine * 2) / around - middle, side = outer * std::sin(angle);
        const double foot = outer * std::cos(angle);
        for (int k = 0; k <= high; ++k) {
          const double y = side * std::cos(turn) - z_of(k) * std::sin(turn) + lean * part * part,
                       z = side * std::sin(turn) + z_of(k) * std::cos(turn) * (1 + lean * side * part), x = foot + length * part;
          m.nodes.push_back({x * std::cos(middle) - y * std::sin(middle), x * std::sin(middle) + y * std::cos(middle), z});
          m.held.push_back(false);
        }
      }
    }
    const auto node = [&](int a, int r, int k) {
      return r == 0 ? ring(from + a, deep, k) : first + ((r - 1) * (wide + 1) + a) * (high + 1) + k;
    };
    for (int a = 0; a < wide; ++a) {
      for (int r = 0; r < radial; ++r) {
        for (int k = 0; k < high; ++k) add(node, a, r, k);
      }
    }
  }
  return m;
}

StructureParts assembled_bricks(const BrickMesh& mesh, const Material& material, double spin, const Vector& displacement) {
  StructureParts p;
  p.spin = spin;
  std::vector<int> first(mesh.nodes.size(), -1);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    if (mesh.held[n]) continue;
    first[n] = static_cast<int>(p.coordinates.size());
    for (int d = 0; d < 3; ++d) p.coordinates.push_back({static_cast<long>(n) + 1, d});
  }
  std::vector<Eigen::Triplet<double>> mass, stiffness;
  Element k;
  Scalar8 m;
  for (const auto& b : mesh.bricks) {
    const Corners x = corners_of(mesh, b);
    element(x, material, k, m);
    Scalar8 stressed = Scalar8::Zero();
    if (displacement.size() > 0) {
      Eigen::Matrix<double, 24, 1> u;
      for (std::size_t c = 0; c < 8; ++c) u.segment<3>(3 * static_cast<Index>(c)) = displacement.segment<3>(3 * b[c]);
      stressed = stress_stiffness(x, material, u);
    }
    for (std::size_t c = 0; c < 8; ++c) {
      for (std::size_t d = 0; d < 8; ++d) {
        const int row = first[static_cast<std::size_t>(b[c])], column = first[static_cast<std::size_t>(b[d])];
        if (row < column || column < 0) continue;
        const auto rc = static_cast<Index>(c), cc = static_cast<Index>(d);
        for (int i = 0; i < 3; ++i) {
          for (int j = 0; j < 3; ++j) {
            if (row + i < column + j) continue;
            double value = k(3 * rc + i, 3 * cc + j);
            if (i == j) {
              value += stressed(rc, cc);
              mass.emplace_back(row + i, column + j, m(rc, cc));
              if (i < 2) value -= spin * spin * m(rc, cc);
            }
            stiffness.emplace_back(row + i, column + j, value);
          }
        }
      }
    }
  }
  const auto n = static_cast<Index>(p.coordinates.size());
  p.mass.resize(n, n);
  p.stiffness.resize(n, n);
  p.mass.setFromTriplets(mass.begin(), mass.end());
  std::vector<Eigen::Triplet<double>>().swap(mass);
  p.stiffness.setFromTriplets(stiffness.begin(), stiffness.end());
  return p;
}

// K u = Ω²M r, r the arms across z. What balances itself needs no support but six of three corners.
Vector displacement_under_spin(const BrickMesh& mesh, const Material& material, double spin) {
  const StructureParts still = assembled_bricks(mesh, material, 0);
  const auto n = static_cast<Index>(still.coordinates.size());
  Matrix arms(n, 1);
  std::vector<Index> kept;
  std::vector<int> node;
  const auto& first = mesh.nodes.front();
  const bool free = std::none_of(mesh.held.begin(), mesh.held.end(), [](bool held) { return held; });
  const auto farthest = [&](std::size_t d) {  // along an edge from the first node
    long best = 0;
    for (std::size_t k = 0; k < mesh.nodes.size(); ++k) {
      const auto& at = mesh.nodes[k];
      const bool on_edge = at[(d + 1) % 3] == first[(d + 1) % 3] && at[(d + 2) % 3] == first[(d + 2) % 3];
      if (on_edge && std::abs(at[d] - first[d]) > std::abs(mesh.nodes[static_cast<std::size_t>(best)][d] - first[d]))
        best = static_cast<long>(k);
    }
    return best + 1;
  };
  const long along_x = farthest(0), along_y = farthest(1);
  for (Index k = 0; k < n; ++k) {
    const MeshCoordinate& c = still.coordinates[static_cast<std::size_t>(k)];
    arms(k, 0) = c.direction < 2 ? mesh.nodes[static_cast<std::size_t>(c.node - 1)][static_cast<std::size_t>(c.direction)] : 0;
    const bool supported = free && (c.node == 1 || (c.node == along_x && c.direction > 0) || (c.node == along_y && c.direction == 2));
    if (supported) continue;
    kept.push_back(k);
    node.push_back(static_cast<int>(c.node - 1));
  }
  const Matrix load = spin * spin * sparse::symmetric_times(still.mass, arms);
  const SparseMatrix k = sparse::restricted(still.stiffness, kept);
  const std::vector<int> order = sparse::coordinate_order(sparse::node_places({&k}, node), node);
  sparse::SymmetricFactor factor(k, order, sparse::SymmetricFactor::Keep::factors);
  factor.factor(k);
  const Matrix u = factor.solve(load(kept, Eigen::all));
  Vector all = Vector::Zero(3 * static_cast<Index>(mesh.nodes.size()));
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const MeshCoordinate& c = still.coordinates[static_cast<std::size_t>(kept[i])];
    all(3 * (c.node - 1) + c.direction) = u(static_cast<Index>(i), 0);
  }
  return all;
}

}  // namespace gyromode::bench
