#pragma once

#include "gyromode/rotor/rotor.h"
#include "support/random_matrices.h"

#include <algorithm>
#include <cmath>

namespace gyromode::support {

/// A rotor of one or two spools: sections of any theory, some tapered or hollow, discs by mass or geometry, with
/// offsets, bearings isotropic or not, some with housings, some supports, a tension or compression, some speed.
inline RotorParts random_rotor(Source& source) {
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(source.bits); };
  const auto often = [&](double share) { return uniform(0, 1) < share; };
  RotorParts p;
  p.speed = uniform(-1, 1) < 0 ? 0 : std::pow(10, uniform(0, 3.5));
  p.materials = {{"steel", 2.1e11, 8.1e10, 7800}, {"light", 7e10, 2.6e10, 2700}};
  const bool two = often(0.3);
  if (two) p.spools = {{"inner", 1, 0}, {"outer", uniform(-2, 2), 0.1}};
  for (std::size_t spool = 0; spool < (two ? 2U : 1U); ++spool) {
    const std::string name = two ? p.spools[spool].name : "";
    const double start = spool == 0 ? 0 : 0.1;
    double end = start;
    const Index sections = source.integer(1, 3);
    for (Index k = 0; k < sections; ++k) {
      ShaftSection s;
      s.spool = name;
      s.material = often(0.7) ? "steel" : "light";
      s.length = 0.02 * std::round(uniform(0.2, 0.6) / 0.02);
      s.outer_diameter[0] = uniform(0.03, 0.1);
      s.outer_diameter[1] = often(0.3) ? uniform(0.03, 0.1) : s.outer_diameter[0];
      const double bore = often(0.4) ? uniform(0.2, 0.8) : 0;
      for (int i = 0; i < 2; ++i) s.inner_diameter[i] = bore * s.outer_diameter[i];
      s.elements = source.integer(1, 3);
      s.theory = static_cast<ShaftTheory>(source.integer(0, 2));
      end += s.length;
      p.shafts.push_back(s);
    }
    const Index discs = source.integer(1, 2);
    for (Index k = 0; k < discs; ++k) {
      Disc d;
      d.spool = name;
      d.position = std::clamp(0.02 * std::round(uniform(start, end) / 0.02) + 0.007, start, end);  // no two parts a hair apart
      d.offset = often(0.3) ? uniform(-0.05, 0.05) : 0;
      if (often(0.5)) {
        d.geometry = DiscGeometry{"steel", uniform(0.02, 0.06), 0.02, uniform(0.15, 0.4)};
      } else {
        d.mass = uniform(2, 20);
        d.diametral_inertia = uniform(0.01, 0.2);
        d.polar_inertia = uniform(0, 2) * d.diametral_inertia;
      }
      p.discs.push_back(d);
    }
    for (const double position : {start, end}) {
      if (often(0.15)) {
        Support s;
        s.spool = name;
        s.position = position;
        s.x = s.y = true;
        s.tilt_x = s.tilt_y = often(0.3);
        p.supports.push_back(s);
        continue;
      }
      Bearing b;
      b.spool = name;
      b.position = position;
      b.kxx = std::pow(10, uniform(5, 9));
      b.kyy = often(0.5) ? b.kxx : b.kxx * uniform(0.3, 3);
      if (often(0.2)) b.kxy = uniform(-0.5, 0.5) * std::sqrt(b.kxx * b.kyy);
      if (often(0.2)) b.tilt_xx = b.tilt_yy = uniform(1e3, 1e5);
      if (often(0.2)) {
        b.housing_mass = uniform(1, 10);
        b.housing_kxx = std::pow(10, uniform(6, 9));
        b.housing_kyy = std::pow(10, uniform(6, 9));
      }
      p.bearings.push_back(b);
    }
  }
  if (two) {
    Bearing b;
    b.spool = "outer";
    b.to = "inner";
    b.position = 0.15;
    b.kxx = b.kyy = std::pow(10, uniform(5, 8));
    p.bearings.push_back(b);
  }
  if (often(0.2)) p.axial_force = uniform(-1e3, 1e4);
  return p;
}

}  // namespace gyromode::support
