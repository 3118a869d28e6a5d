#include "rows.h"

#include "machine.h"
#include "process.h"
#include "rivals.h"
#include "systems.h"

#include "gyromode/dense/mass_normal.h"
#include "gyromode/dense/solve.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/modes/modes.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

namespace gyromode::bench {

namespace {

constexpr std::uint64_t seed = 1979;
constexpr double moderate = 1e3;
constexpr double wide = 1e6;  // of K: frequencies over more than four decades

// A system of one component, and what dense::solve made of it last.
struct Ours {
  System system;
  Component component;
  std::string solver;

  explicit Ours(System given) : system(std::move(given)) {
    auto components = analyse(system).components;
    if (components.size() != 1) throw std::logic_error("a benchmark system falls apart into components");
    component = std::move(components.front());
  }

  void solve() { solver = dense::solve(system, component).solver; }
  void find() { solver = find_modes(system, {.window = {}, .lowest = {}, .keep = {}, .shapes = true, .progress = {}}).solver; }

  Contestant dense_solve() {
    return {"gyromode", "dense::solve, method automatic: roots and shapes", {}, [this] { solve(); }};
  }
};

template <class Rival>
Contestant against(Rival& rival, std::string name, const std::string& what) {
  return {std::move(name), fmt::format("{}; {}", Rival::options, what), [&rival] { rival.reset(); }, [&rival] { rival.solve(); }};
}

// W of theory (T5) from the same building blocks: what is left of the quadrature solver when everything but its
// eigenvalue problem is free.
Matrix w_matrix(const System& system, const Component& component) {
  const auto& first = component.in_phase;
  const auto& second = component.in_quadrature;
  const dense::MassNormal m1(dense::restricted(system.mass(), first, first));
  const dense::MassNormal m2(dense::restricted(system.mass(), second, second));
  const Matrix k1 = dense::restricted(system.stiffness(), first, first);
  const Matrix f = m1.stiffness_root(*dense::StiffnessFactor::of(k1, inertia_of_k(k1)));
  const Matrix b = m1.coupling(dense::restricted(system.gyroscopic(), first, second), m2);
  Matrix fb(f.rows(), f.cols() + b.cols());
  fb << f, b;
  Matrix w = lapack::gram(fb);
  w.bottomRightCorner(b.cols(), b.cols()) += m2.stiffness(dense::restricted(system.stiffness(), second, second));
  return w;
}

Row timed(std::string key, std::string title, const std::vector<Contestant>& contestants, int rounds) {
  const Others others;
  Row row{std::move(key), std::move(title), {}, 0, interleaved(contestants, rounds)};
  row.others = others.share();
  return row;
}

Row timed(std::string key, std::string title, const std::vector<Contestant>& contestants, const Ours& ours, int rounds) {
  Row row = timed(std::move(key), std::move(title), contestants, rounds);
  row.solver = ours.solver;
  return row;
}

std::string titled(const char* what, Index n) { return fmt::format("{}, n = {}", what, n); }

}  // namespace

Index scaled_order(Index n, const RowOptions& options) {
  return std::max<Index>(8, 2 * static_cast<Index>(0.5 * options.n_scale * static_cast<double>(n)));
}

std::vector<Row> quadrature_rows(const RowOptions& options) {
  const Index n = scaled_order(1000, options);
  Dsyevd random(random_symmetric(n, seed));
  std::vector<Row> rows;
  for (const double condition : {moderate, wide}) {
    Ours ours(quadrature_definite(n, condition, seed));
    Dsygvd at_rest(ours.system.stiffness(), ours.system.mass());
    Dsyevd w(w_matrix(ours.system, ours.component));
    const std::string title = titled(condition == moderate ? "quadrature class, K > 0" : "quadrature class, K > 0, wide spectrum", n);
    rows.push_back(timed("a", title,
                         {ours.dense_solve(), against(at_rest, "dsygvd of K, M", "the system at rest, full matrices of order n"),
                          against(w, "dsyevd of W", "the real symmetric matrix of order n that has the frequencies, given"),
                          against(random, "dsyevd, random", "a random symmetric matrix of order n")},
                         ours, options.rounds));
    if (condition != moderate) continue;
    Dgeev first_order(companion(ours.system));
    rows.push_back(
        timed("a", title, {ours.dense_solve(), against(first_order, "dgeev of order 2n", "companion form, given")}, ours, options.rounds));
  }
  return rows;
}

std::vector<Row> general_rows(const RowOptions& options) {
  const Index n = scaled_order(1000, options);
  Ours ours(general_definite(n, seed));
  Dsyevd random(random_symmetric(2 * n, seed));
  Dgeev first_order(companion(ours.system));
  const std::string title = titled("general, K > 0", n);
  std::vector<Row> rows;
  rows.push_back(timed("b", title, {ours.dense_solve(), against(random, "dsyevd of order 2n", "a random symmetric matrix of order 2n")},
                       ours, options.rounds));
  rows.push_back(
      timed("b", title, {ours.dense_solve(), against(first_order, "dgeev of order 2n", "companion form, given")}, ours, options.rounds));
  return rows;
}

std::vector<Row> indefinite_rows(const RowOptions& options) {
  const Index n = scaled_order(500, options);
  std::vector<Row> rows;
  for (const Balance balance : {Balance::stabilised, Balance::mixed}) {
    Ours ours(quadrature_indefinite(n, balance, seed));
    Dgeev first_order(companion(ours.system));
    const char* what = balance == Balance::stabilised ? "quadrature class, both blocks indefinite, stabilised"
                                                      : "quadrature class, both blocks indefinite, unstable roots";
    rows.push_back(timed("c", titled(what, n), {ours.dense_solve(), against(first_order, "dgeev of order 2n", "companion form, given")},
                         ours, options.rounds));
  }
  return rows;
}

std::vector<Row> certificate_rows(const RowOptions& options) {
  std::vector<Row> rows;
  const auto add = [&](const char* what, System system) {
    const Index n = system.size();
    Ours ours(std::move(system));
    const Contestant certified{"find_modes", "all modes with shapes, residuals, energy signs, counts", {}, [&ours] { ours.find(); }};
    const Contestant solved{"dense::solve", "the solver alone", {}, [&ours] { ours.solve(); }};
    rows.push_back(timed("d", titled(what, n), {certified, solved}, ours, options.rounds));
  };
  add("quadrature class, K > 0", quadrature_definite(scaled_order(1000, options), moderate, seed));
  add("general, K > 0", general_definite(scaled_order(1000, options), seed));
  add("quadrature class, both blocks indefinite, stabilised", quadrature_indefinite(scaled_order(500, options), Balance::stabilised, seed));
  add("quadrature class, both blocks indefinite, unstable roots", quadrature_indefinite(scaled_order(500, options), Balance::mixed, seed));
  return rows;
}

std::vector<Row> process_rows(const RowOptions& options) {
  const auto started = [](const char* name, std::vector<std::string> command) {
    return Contestant{name, fmt::format("{}", fmt::join(command, " ")), {}, [command] { run_to_end(command); }};
  };
  return {timed("e", "a process from start to end, 6 coordinates",
                {started("gyromode modes", {options.program.string(), "modes", options.model.string()}),
                 started("gyromode --version", {options.program.string(), "--version"}), started("true", {"/bin/true"})},
                options.process_rounds)};
}

}  // namespace gyromode::bench
