#include "gyromode/rotor/part_energies.h"
#include "gyromode/rotor/pieces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gyromode {

namespace {

// Adds parts to the matrices; what is held is left out.
class Matrices {
 public:
  explicit Matrices(const Rotor& r) : mass(Matrix::Zero(r.size(), r.size())), gyroscopic(mass), stiffness(mass) {}

  static void add(Matrix& to, Index i, Index j, double value) {
    if (i >= 0 && j >= 0) to(i, j) += value;
  }
  // An element in both planes: (x, θy) and (y, −θx) at its ends.
  void add(const Station& a, const Station& b, const ShaftElement& e, double speed_ratio, double tension) {
    const Index x[4] = {a.coordinate[0], a.coordinate[3], b.coordinate[0], b.coordinate[3]};
    const Index y[4] = {a.coordinate[1], a.coordinate[2], b.coordinate[1], b.coordinate[2]};
    const double sign[4] = {1, -1, 1, -1};  // of the slope in the plane of y
    for (Index i = 0; i < 4; ++i) {
      for (Index j = 0; j < 4; ++j) {
        const double both = sign[i] * sign[j], k = e.stiffness(i, j) + tension * e.geometric(i, j);
        add(mass, x[i], x[j], e.mass(i, j));
        add(mass, y[i], y[j], both * e.mass(i, j));
        add(stiffness, x[i], x[j], k);
        add(stiffness, y[i], y[j], both * k);
        const double coupling = 2 * speed_ratio * e.rotary(i, j);
        add(gyroscopic, x[i], y[j], sign[j] * coupling);
        add(gyroscopic, y[i], x[j], -sign[i] * coupling);
      }
    }
  }
  // A rigid body whose centre is `offset` beyond the station: u + offset θ.
  void add(const Station& s, double m, double polar, double diametral, double offset, double speed_ratio) {
    const auto& c = s.coordinate;
    const double tilt = diametral + m * offset * offset;
    add(mass, c[0], c[0], m);
    add(mass, c[1], c[1], m);
    add(mass, c[2], c[2], tilt);
    add(mass, c[3], c[3], tilt);
    for (const auto& [i, j, value] : {std::tuple(c[0], c[3], m * offset), {c[1], c[2], -m * offset}}) {
      add(mass, i, j, value);
      add(mass, j, i, value);
    }
    add(gyroscopic, c[2], c[3], polar * speed_ratio);
    add(gyroscopic, c[3], c[2], -polar * speed_ratio);
  }
  // A spring between two coordinates, or one and the ground (−1).
  void add_spring(Index a, Index b, double k) { add_springs({a, a}, {b, b}, k); }
  // k (a₀ − b₀)(a₁ − b₁): the coupling of two directions, both ways where they differ.
  void add_springs(const std::array<Index, 2>& a, const std::array<Index, 2>& b, double k) {
    if (k == 0 || !std::isfinite(k)) return;
    const bool one = a[0] == a[1] && b[0] == b[1];
    const auto both = [&](Index i, Index j, double value) {
      add(stiffness, i, j, value);
      if (!one) add(stiffness, j, i, value);
    };
    both(a[0], a[1], k);
    both(b[0], b[1], k);
    both(a[0], b[1], -k);
    both(b[0], a[1], -k);
  }

  Matrix mass, gyroscopic, stiffness;
};

void add_disc(const Rotor& r, const Disc& d, Matrices& to) {
  const std::size_t spool = r.spool_named(d.spool);
  double mass = d.mass, polar = d.polar_inertia, diametral = d.diametral_inertia;
  if (d.geometry) {
    const DiscGeometry& g = *d.geometry;
    const double squares = g.outer_diameter * g.outer_diameter + g.inner_diameter * g.inner_diameter;
    mass = r.material_named(g.material).density * std::numbers::pi / 4 * (g.outer_diameter - g.inner_diameter) *
           (g.outer_diameter + g.inner_diameter) * g.width;
    polar = mass * squares / 8;
    diametral = mass * (squares / 16 + g.width * g.width / 12);
  }
  to.add(r.station_at(spool, d.position), mass, polar, diametral, d.offset, r.spools()[spool].speed_ratio);
}

void add_point_mass(const Rotor& r, const PointMass& m, Matrices& to) {
  to.add(r.station_at(r.spool_named(m.spool), m.position), m.mass, 0, 0, 0, 0);
}

void add_bearing(const Rotor& r, std::size_t which, Matrices& to) {
  const Bearing& b = r.parts().bearings[which];
  const auto& a = r.station_at(r.spool_named(b.spool), b.position).coordinate;
  std::array<Index, 4> other{-1, -1, -1, -1};
  if (!b.to.empty()) other = r.station_at(r.spool_named(b.to), b.position).coordinate;
  if (b.has_housing()) {
    for (std::size_t d = 0; d < 2; ++d) other[d] = r.housing(which)[d];
    Matrices::add(to.mass, other[0], other[0], b.housing_mass);
    Matrices::add(to.mass, other[1], other[1], b.housing_mass);
    to.add_spring(other[0], -1, b.housing_kxx);
    to.add_spring(other[1], -1, b.housing_kyy);
  }
  to.add_spring(a[0], other[0], b.kxx);
  to.add_spring(a[1], other[1], b.kyy);
  to.add_springs({a[0], a[1]}, {other[0], other[1]}, b.kxy);
  to.add_spring(a[2], other[2], b.tilt_xx);
  to.add_spring(a[3], other[3], b.tilt_yy);
  to.add_springs({a[2], a[3]}, {other[2], other[3]}, b.tilt_xy);
}

}  // namespace

namespace {

void add_what_they_carry(const Rotor& r, Matrices& all) {
  for (const Disc& d : r.parts().discs) add_disc(r, d, all);
  for (const PointMass& m : r.parts().point_masses) add_point_mass(r, m, all);
  for (std::size_t k = 0; k < r.parts().bearings.size(); ++k) add_bearing(r, k, all);
}

SpinFamily family_of(const Rotor& r, Matrices all) {
  const Index n = r.size();
  return {std::move(all.mass), Matrix::Zero(n, n), std::move(all.gyroscopic), std::move(all.stiffness), {}, r.labels(), {}};
}

}  // namespace

SpinFamily assembled(const Rotor& r) {
  Matrices all(r);
  each_piece(r, [&](const PieceBetween& p) { all.add(p.lower, p.upper, shaft_element(p.piece), p.speed_ratio, r.parts().axial_force); });
  add_what_they_carry(r, all);
  return family_of(r, std::move(all));
}

SpinFamily assembled_without_shafts(const Rotor& r) {
  Matrices all(r);
  add_what_they_carry(r, all);
  return family_of(r, std::move(all));
}

std::vector<PartEnergy> part_energies(const Rotor& r, const ComplexVector& x) {
  std::vector<PartEnergy> all;
  const auto form = [&](const Matrix& a) { return x.real().dot(a * x.real()) + x.imag().dot(a * x.imag()); };
  const auto see = [&](const std::string& part, const Matrices& m) { all.push_back({part, form(m.mass), form(m.stiffness)}); };
  for (std::size_t k = 0; k < r.parts().shafts.size(); ++k) {
    Matrices of_section(r);
    each_piece(r, [&](const PieceBetween& p) {
      if (&p.section == &r.parts().shafts[k])
        of_section.add(p.lower, p.upper, shaft_element(p.piece), p.speed_ratio, r.parts().axial_force);
    });
    see(fmt::format("shaft {}", k + 1), of_section);
  }
  for (std::size_t k = 0; k < r.parts().discs.size(); ++k) {
    Matrices of_disc(r);
    add_disc(r, r.parts().discs[k], of_disc);
    see(fmt::format("disk {}", k + 1), of_disc);
  }
  for (std::size_t k = 0; k < r.parts().point_masses.size(); ++k) {
    Matrices of_mass(r);
    add_point_mass(r, r.parts().point_masses[k], of_mass);
    see(fmt::format("point mass {}", k + 1), of_mass);
  }
  for (std::size_t k = 0; k < r.parts().bearings.size(); ++k) {
    Matrices of_bearing(r);
    add_bearing(r, k, of_bearing);
    see(fmt::format("bearing {}", k + 1), of_bearing);
  }
  return all;
}

}  // namespace gyromode
