// Row k: Campbell diagram of a rotor of 60 stations, 200 spins, 12 modes, every spin certified, beside the same sweep
// by dgeev of the companion form, without branches or certificates, as scipy.linalg.eig does it.
#include "machine.h"
#include "rivals.h"
#include "rows.h"

#include "gyromode/models/model.h"
#include "gyromode/models/rotor_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace gyromode::bench {

namespace {

Rotor two_discs(Index elements, double kyy) {
  RotorParts p;
  p.materials = {{"steel", 2.11e11, 8.12e10, 7810}};
  ShaftSection shaft;
  shaft.material = "steel";
  shaft.length = 1.5;
  for (double& d : shaft.outer_diameter) d = 0.05;
  shaft.elements = elements;
  p.shafts = {shaft};
  for (const auto& [position, diameter] : {std::pair(0.5, 0.28), {1.0, 0.35}}) {
    Disc d;
    d.position = position;
    d.geometry = DiscGeometry{"steel", 0.07, 0, diameter};
    p.discs.push_back(d);
  }
  for (const double position : {0.0, 1.5}) {
    Bearing b;
    b.position = position;
    b.kxx = 1e6;
    b.kyy = kyy;
    p.bearings.push_back(b);
  }
  return Rotor(p);
}

}  // namespace

std::vector<Row> campbell_rows(const RowOptions& options) {
  constexpr int spins = 200, most_rounds = 3;
  std::vector<Row> rows;
  for (const auto& [words, kyy] : {std::pair("isotropic bearings", 1e6), {"orthotropic bearings", 8e5}}) {
    const Rotor rotor = two_discs(std::max<Index>(scaled_order(60, options) - 1, 7), kyy);
    const Model model(std::make_shared<RotorModel>(rotor));
    const SpinFamily family = assembled(rotor);
    CampbellOptions asked;
    asked.lowest = 12;
    for (int k = 0; k < spins; ++k) asked.spins.push_back(1000.0 * k / (spins - 1));
    Campbell last;
    const Contestant ours{"campbell", "branches, encounters, intersections, certificates", {}, [&] { last = model.campbell(asked); }};
    const Contestant rival{"dgeev, every spin", fmt::format("{}; companion form", Dgeev::options), {}, [&] {
                             for (const double spin : asked.spins) {
                               Dgeev each(companion(family.at(spin)));
                               each.reset();
                               each.solve();
                             }
                           }};
    const Others others;
    Row row{"k",
            fmt::format("Campbell diagram, {}, {} coordinates, {} spins, 12 modes", words, model.size(), spins),
            {},
            0,
            interleaved({ours, rival}, std::min(options.rounds, most_rounds))};
    row.solver = fmt::format("{}complete at every spin", last.is_complete() ? "" : "not ");
    row.others = others.share();
    rows.push_back(row);
  }
  return rows;
}

}  // namespace gyromode::bench
