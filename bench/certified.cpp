// Rows h and i: a certified answer against the rival's bare one, where K is indefinite; and how the time of every verb
// grows with the order.
#include "machine.h"
#include "rivals.h"
#include "rows.h"
#include "systems.h"

#include "gyromode/modes/modes.h"
#include "gyromode/stability/stability_margin.h"

#include <fmt/format.h>

#include <memory>

namespace gyromode::bench {

namespace {

constexpr std::uint64_t seed = 1979;

ModesOptions with_shapes() {
  ModesOptions options;
  options.shapes = true;
  return options;
}

Row against_dgeev(const std::string& title, const System& system, int rounds) {
  auto path = std::make_shared<std::string>();
  Dgeev rival(companion(system));
  const Contestant ours{"find_modes", "find_modes with shapes, counts and verdict", {}, [&, path] {
                          const ModesResult r = find_modes(system, with_shapes());
                          *path = fmt::format("{}; {}, {}", r.solver, to_string(r.coverage.status), to_string(r.stability));
                        }};
  const Contestant bare{"dgeev of order 2n", fmt::format("{}; companion form, given", Dgeev::options), [&] { rival.reset(); },
                        [&] { rival.solve(); }};
  const Others others;
  Row row{"h", title, {}, 0, interleaved({ours, bare}, rounds)};
  row.others = others.share();
  row.solver = *path;
  return row;
}

// One verb at one order; the ratio to the half order tells the exponent.
Row growth(const std::string& title, const System& system, const System& half, const std::function<void(const System&)>& verb, int rounds) {
  const Others others;
  Row row{"i", title, {}, 0, interleaved({{"n", "", {}, [&] { verb(system); }}, {"n/2", "", {}, [&] { verb(half); }}}, rounds)};
  row.others = others.share();
  return row;
}

}  // namespace

std::vector<Row> certified_rows(const RowOptions& options) {
  std::vector<Row> rows;
  const int few = std::min(options.rounds, 3);
  const auto general = [&](const char* what, Index order, Regime regime) {
    const Index n = scaled_order(order, options);
    rows.push_back(against_dgeev(fmt::format("general, K indefinite, {}, n = {}", what, n), general_indefinite(n, regime, seed),
                                 order > 500 ? few : options.rounds));
  };
  general("plain", 1000, Regime::plain);
  general("G twentyfold", 1000, Regime::spin20);
  general("G 1e6-fold", 400, Regime::huge);
  general("two copies", 400, Regime::copies);
  general("graded", 400, Regime::graded);
  general("mixed units", 400, Regime::mixed);
  general("spinning beam", 400, Regime::beam);
  const Index n = scaled_order(500, options);
  rows.push_back(against_dgeev(fmt::format("quadrature, both blocks indefinite, unstable, n = {}", n),
                               quadrature_indefinite(n, Balance::mixed, seed), options.rounds));
  return rows;
}

std::vector<Row> growth_rows(const RowOptions& options) {
  std::vector<Row> rows;
  const std::vector<std::pair<const char*, std::function<void(const System&)>>> verbs{
      {"modes with shapes", [](const System& s) { find_modes(s, with_shapes()); }},
      {"count",
       [](const System& s) {
         count_modes(s, {0, 1});
       }},
      {"structure", [](const System& s) { analyse(s, HiddenSearch::always); }},
      {"stability margin", [](const System& s) { stiffness_margin(s, 0); }}};
  const auto of = [&](const char* what, const std::function<System(Index)>& made) {
    for (const Index order : {200, 400, 800, 1600}) {
      const Index n = scaled_order(order, options), half = scaled_order(order / 2, options);
      const System whole = made(n), part = made(half);
      for (const auto& [verb, call] : verbs)
        rows.push_back(growth(fmt::format("{}, {}, n = {}", what, verb, n), whole, part, call, order > 500 ? 1 : 3));
    }
  };
  of("quadrature, K > 0", [](Index n) { return quadrature_definite(n, 1e3, seed); });
  of("general, K > 0", [](Index n) { return general_definite(n, seed); });
  of("quadrature, both blocks indefinite", [](Index n) { return quadrature_indefinite(n, Balance::mixed, seed); });
  of("general, K indefinite", [](Index n) { return general_indefinite(n, Regime::plain, seed); });
  of("spinning beam", [](Index n) { return general_indefinite(n, Regime::beam, seed); });
  return rows;
}

}  // namespace gyromode::bench
