// Row g: whether looking for a reversing symmetry pays, the search counted in.
#include "machine.h"
#include "rows.h"
#include "systems.h"

#include "gyromode/dense/solve.h"
#include "gyromode/lapack/multiply.h"

#include <Eigen/QR>
#include <fmt/format.h>

#include <memory>
#include <random>

namespace gyromode::bench {

namespace {

constexpr std::uint64_t seed = 1979;

// The same system in coordinates that hide its partition: q = T q′, T orthogonal.
System hidden(const System& s) {
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal;
  Matrix a(s.size(), s.size());
  for (double& x : a.reshaped()) x = normal(bits);
  const Matrix t = Eigen::HouseholderQR<Matrix>(a).householderQ();
  const auto turned = [&](const Matrix& m) { return lapack::multiply_tn(t, lapack::multiply(m, t)); };
  return System(symmetric_part(turned(s.mass())), skew_part(turned(s.gyroscopic())), symmetric_part(turned(s.stiffness())));
}

Row against_general(const std::string& title, const System& system, int rounds) {
  auto path = std::make_shared<std::string>();
  const Structure visible = analyse(system, HiddenSearch::never);
  const Contestant ours{"search and solve", "find_reversing_symmetry and the quadrature solver: roots and shapes", {}, [&, path] {
                          const Structure s = analyse(system, HiddenSearch::always);
                          *path = dense::solve(system, s.components.front()).solver;
                        }};
  const Contestant general{
      "general", "dense::solve without a partition", {}, [&] { dense::solve(system, visible.components.front(), Method::general); }};
  const Contestant search{
      "search alone", "what it costs where there is nothing to find", {}, [&] { analyse(system, HiddenSearch::always); }};
  const Others others;
  Row row{"g", title, {}, 0, interleaved({ours, general, search}, rounds)};
  row.others = others.share();
  row.solver = *path;
  return row;
}

}  // namespace

std::vector<Row> hidden_rows(const RowOptions& options) {
  std::vector<Row> rows;
  for (const Index order : {125, 250, 500, 1000}) {
    const Index n = scaled_order(order, options);
    rows.push_back(
        against_general(fmt::format("hidden quadrature, K > 0, n = {}", n), hidden(quadrature_definite(n, 1e3, seed)), options.rounds));
  }
  for (const Index order : {125, 250, 500, 1000}) {
    const Index n = scaled_order(order, options);
    // Without a partition the largest takes half a minute a round.
    rows.push_back(against_general(fmt::format("hidden quadrature, both blocks indefinite, n = {}", n),
                                   hidden(quadrature_indefinite(n, Balance::stabilised, seed)), n > 600 ? 1 : std::min(options.rounds, 3)));
  }
  return rows;
}

}  // namespace gyromode::bench
