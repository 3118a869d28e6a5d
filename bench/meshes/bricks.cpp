#include "meshes/bricks.h"

#include <Eigen/LU>

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

void element(const std::array<std::array<double, 3>, 8>& x, const Material& of, Element& k, Scalar8& m) {
  const auto d = elasticity(of);
  k.setZero();
  m.setZero();
  const double at = 1 / std::sqrt(3.0);
  for (const auto& g : corner) {
    Eigen::Matrix<double, 8, 3> slope;
    Eigen::Matrix<double, 8, 1> shape;
    for (int c = 0; c < 8; ++c) {
      double f[3], s[3];
      for (int i = 0; i < 3; ++i) {
        const double sign = 2 * corner[static_cast<std::size_t>(c)][static_cast<std::size_t>(i)] - 1,
                     p = at * (2 * g[static_cast<std::size_t>(i)] - 1);
        f[i] = 0.5 * (1 + sign * p);
        s[i] = 0.5 * sign;
      }
      shape(c) = f[0] * f[1] * f[2];
      slope.row(c) << s[0] * f[1] * f[2], f[0] * s[1] * f[2], f[0] * f[1] * s[2];
    }
    Eigen::Matrix3d j = Eigen::Matrix3d::Zero();
    for (int c = 0; c < 8; ++c) {
      const auto& p = x[static_cast<std::size_t>(c)];
      j += slope.row(c).transpose() * Eigen::RowVector3d(p[0], p[1], p[2]);
    }
    const double volume = std::abs(j.determinant());
    const Eigen::Matrix<double, 8, 3> b = slope * j.inverse().transpose();
    Eigen::Matrix<double, 6, 24> strain = Eigen::Matrix<double, 6, 24>::Zero();
    for (int c = 0; c < 8; ++c) {
      const double bx = b(c, 0), by = b(c, 1), bz = b(c, 2);
      strain.block<6, 3>(0, 3 * c) << bx, 0, 0, 0, by, 0, 0, 0, bz, by, bx, 0, 0, bz, by, bz, 0, bx;
    }
    k += volume * strain.transpose() * d * strain;
    m += of.density * volume * shape * shape.transpose();
  }
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

StructureParts assembled_bricks(const BrickMesh& mesh, const Material& material, double spin) {
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
    std::array<std::array<double, 3>, 8> x{};
    for (std::size_t c = 0; c < 8; ++c) x[c] = mesh.nodes[static_cast<std::size_t>(b[c])];
    element(x, material, k, m);
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

}  // namespace gyromode::bench
