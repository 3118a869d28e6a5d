#include "gyromode/rotor/outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gyromode {

namespace {

double radius_of(const Disc& d) {
  if (d.geometry) return 0.5 * d.geometry->outer_diameter;
  return d.mass > 0 ? std::sqrt(2 * std::max(d.polar_inertia, d.diametral_inertia) / d.mass) : 0;
}

// x, y, θx, θy of a station; what is held does not move.
std::array<Complex, 4> motion_of(const Station& s, const ComplexVector& shape) {
  std::array<Complex, 4> all{};
  for (std::size_t d = 0; d < 4; ++d) all[d] = s.coordinate[d] >= 0 ? shape(s.coordinate[d]) : Complex(0);
  return all;
}

// The cubic with the values a, b and slopes at the ends of a piece of length l, at the share t of it.
Complex cubic(const Complex& a, const Complex& slope_a, const Complex& b, const Complex& slope_b, double l, double t) {
  const double t2 = t * t, t3 = t2 * t;
  return (1 - 3 * t2 + 2 * t3) * a + (t - 2 * t2 + t3) * l * slope_a + (3 * t2 - 2 * t3) * b + (t3 - t2) * l * slope_b;
}

std::vector<std::vector<const Station*>> by_spool(const Rotor& r) {
  std::vector<std::vector<const Station*>> all(r.spools().size());
  for (const Station& s : r.stations()) all[s.spool].push_back(&s);
  return all;
}

ComplexMatrix along_shaft(const std::vector<const Station*>& stations, const ComplexVector& shape) {
  ComplexMatrix u = ComplexMatrix::Zero(3, 1 + points_between_stations * static_cast<Index>(stations.size() - 1));
  for (std::size_t k = 0; k + 1 < stations.size(); ++k) {
    const auto a = motion_of(*stations[k], shape), b = motion_of(*stations[k + 1], shape);
    const double l = stations[k + 1]->position - stations[k]->position;
    for (Index i = 0; i <= points_between_stations; ++i) {
      const double t = static_cast<double>(i) / points_between_stations;
      const Index column = points_between_stations * static_cast<Index>(k) + i;
      u(0, column) = cubic(a[0], a[3], b[0], b[3], l, t);
      u(1, column) = cubic(a[1], -a[2], b[1], -b[2], l, t);
    }
  }
  return u;
}

// The ends of its diameter along x: u + θ × r.
ComplexMatrix across_disc(const Station& s, double offset, double radius, const ComplexVector& shape) {
  const auto m = motion_of(s, shape);
  ComplexMatrix u(3, 2);
  for (const int end : {0, 1}) u.col(end) << m[0] + offset * m[3], m[1] - offset * m[2], (end == 0 ? -radius : radius) * m[3];
  return u;
}

}  // namespace

std::vector<ModelOutline> outlines_of(const Rotor& r) {
  std::vector<ModelOutline> all;
  const auto spools = by_spool(r);
  for (std::size_t k = 0; k < spools.size(); ++k) {
    const std::string& name = r.spools()[k].name;
    ModelOutline line{name.empty() ? "shaft" : "shaft " + name, {}};
    for (std::size_t s = 0; s < spools[k].size(); ++s) {
      const double z = spools[k][s]->position;
      line.points.emplace_back(0, 0, z);
      for (Index i = 1; s + 1 < spools[k].size() && i < points_between_stations; ++i)
        line.points.emplace_back(0, 0, z + (spools[k][s + 1]->position - z) * static_cast<double>(i) / points_between_stations);
    }
    all.push_back(std::move(line));
  }
  for (std::size_t k = 0; k < r.parts().discs.size(); ++k) {
    const Disc& d = r.parts().discs[k];
    const double radius = radius_of(d), z = d.position + d.offset;
    all.push_back({fmt::format("disk {}", k + 1), {{radius, 0, z}, {-radius, 0, z}}});
  }
  for (std::size_t k = 0; k < r.parts().bearings.size(); ++k)
    all.push_back({fmt::format("bearing {}", k + 1), {{0, 0, r.parts().bearings[k].position}}});
  return all;
}

std::vector<ComplexMatrix> displacements_of(const Rotor& r, const std::vector<ModelOutline>& outlines, const ComplexVector& shape) {
  std::vector<ComplexMatrix> all;
  for (const auto& stations : by_spool(r)) all.push_back(along_shaft(stations, shape));
  for (const Disc& d : r.parts().discs) {
    const double radius = outlines[all.size()].points.front()(0);
    all.push_back(across_disc(r.station_at(r.spool_named(d.spool), d.position), d.offset, radius, shape));
  }
  for (const Bearing& b : r.parts().bearings) {
    const auto m = motion_of(r.station_at(r.spool_named(b.spool), b.position), shape);
    ComplexMatrix u(3, 1);
    u << m[0], m[1], Complex(0);
    all.push_back(std::move(u));
  }
  return all;
}

}  // namespace gyromode
