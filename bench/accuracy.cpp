#include "accuracy.h"

#include "rivals.h"
#include "systems.h"

#include "gyromode/dense/solve.h"
#include "gyromode/modes/modes.h"
#include "gyromode/system/scale.h"

#include <cmath>
#include <limits>

namespace gyromode::bench {

namespace {

constexpr std::uint64_t seed = 1979;

// λ²M + λG + K measured with the norms computed once.
class Residual {
 public:
  Residual(const Matrix& m, const Matrix& g, const Matrix& k)
      : m_(m), g_(g), k_(k), norm_m_(norm1(m)), norm_g_(norm1(g)), norm_k_(norm1(k)) {}
  explicit Residual(const System& s) : Residual(s.mass(), s.gyroscopic(), s.stiffness()) {}

  double operator()(Complex lambda, const ComplexVector& x) const {
    const double size = std::abs(lambda);
    const ComplexVector h = lambda * lambda * (m_ * x) + lambda * (g_ * x) + k_ * x;
    return h.norm() / ((norm_k_ + size * (norm_g_ + size * norm_m_)) * x.norm());
  }

 private:
  const Matrix &m_, &g_, &k_;
  double norm_m_, norm_g_, norm_k_;
};

class Tally {
 public:
  void add(Complex lambda, double residual) {
    if (lambda.real() < -significant * std::abs(lambda)) return;  // the other half of a quadruple
    growing_ = growing_ || lambda.real() > significant * std::abs(lambda);
    residuals_.push_back(residual);
    real_ = std::max(real_, std::abs(lambda.real()));
    largest_ = std::max(largest_, std::abs(lambda));
  }

  Score score(std::string system, std::string method, Index order) const {
    const double unit = static_cast<double>(order) * std::numeric_limits<double>::epsilon();
    return {std::move(system),
            std::move(method),
            order,
            static_cast<Index>(residuals_.size()),
            quantile(residuals_, 0.5) / unit,
            quantile(residuals_, 1) / unit,
            growing_ ? std::nullopt : std::optional(real_ / largest_)};
  }

 private:
  static constexpr double significant = 1e-4;  // the flutter of these systems is far above, rounding far below
  std::vector<double> residuals_;
  bool growing_ = false;
  double real_ = 0, largest_ = 0;
};

ComplexVector placed(const Spectrum& s, const ComplexVector& part) {
  ComplexVector x(part.size());
  for (Index i = 0; i < part.size(); ++i) x(s.order[static_cast<std::size_t>(i)]) = part(i);
  return x;
}

Tally solved(const System& system, Method method) {
  const Residual residual(system);
  const Spectrum s = dense::solve(system, analyse(system).components.front(), method);
  Tally t;
  for (Index k = 0; k < s.omega.size(); ++k) t.add({0, s.omega(k)}, residual({0, s.omega(k)}, placed(s, s.shape(k))));
  for (Index k = 0; k < s.unstable.count(); ++k) {
    const Complex lambda = s.unstable.lambda[static_cast<std::size_t>(k)];
    t.add(lambda, residual(lambda, placed(s, s.unstable.right.col(k))));
  }
  return t;
}

Tally found(const System& system) {
  const Residual residual(system);
  ModesOptions options;
  options.shapes = true;
  Tally t;
  for (const Mode& mode : find_modes(system, options).modes) t.add({0, mode.omega}, residual({0, mode.omega}, mode.shape));
  return t;
}

// Of the two halves of z = (λx, x) the better one, as Tisseur 2000 advises.
Tally first_order(const System& system) {
  const Residual residual(system);
  const Index n = system.size();
  Dgeev rival(companion(system));
  rival.reset();
  rival.solve();
  Tally t;
  for (const Index k : rival.upper()) {
    const ComplexVector z = rival.vector(k);
    t.add(rival.value(k), std::min(residual(rival.value(k), z.tail(n)), residual(rival.value(k), z.head(n))));
  }
  return t;
}

// K x = ω²M x: a real symmetric problem of the same order, as a yardstick.
Tally at_rest(const System& system) {
  const Matrix none = Matrix::Zero(system.size(), system.size());
  const Residual residual(system.mass(), none, system.stiffness());
  Dsygvd rival(system.stiffness(), system.mass());
  rival.reset();
  rival.solve();
  Tally t;
  for (Index k = 0; k < system.size(); ++k) {
    const Complex lambda(0, std::sqrt(rival.values()(k)));
    t.add(lambda, residual(lambda, rival.vectors().col(k).cast<Complex>()));
  }
  return t;
}

// ‖Ax − μx‖ / ((‖A‖ + |μ|)‖x‖).
Tally symmetric(const Matrix& a) {
  const double norm = norm1(a);
  Dsyevd rival(a);
  rival.reset();
  rival.solve();
  Tally t;
  for (Index k = 0; k < a.rows(); ++k) {
    const double mu = rival.values()(k);
    const Vector x = rival.vectors().col(k);
    t.add({0, std::abs(mu)}, (a * x - mu * x).norm() / ((norm + std::abs(mu)) * x.norm()));
  }
  return t;
}

void compare(std::vector<Score>& league, const std::string& name, const System& system) {
  const Index n = system.size();
  league.push_back(solved(system, Method::automatic).score(name, "gyromode, dense::solve", n));
  league.push_back(found(system).score(name, "gyromode, find_modes", n));
  league.push_back(first_order(system).score(name, "dgeev of order 2n", n));
}

void compare_symmetric(std::vector<Score>& league, const std::string& name, const System& system) {
  league.push_back(solved(system, Method::meirovitch).score(name, "dsygvd of order 2n (Meirovitch 1974)", system.size()));
}

}  // namespace

std::vector<Score> accuracy_league(const RowOptions& options) {
  std::vector<Score> league;
  const System a = quadrature_definite(scaled_order(200, options), 1e3, seed);
  compare(league, "a", a);
  compare_symmetric(league, "a", a);
  league.push_back(at_rest(a).score("a", "dsygvd of K, M at rest", a.size()));
  const System wide = quadrature_definite(scaled_order(200, options), 1e6, seed);
  compare(league, "a, wide spectrum", wide);
  compare_symmetric(league, "a, wide spectrum", wide);
  const System b = general_definite(scaled_order(200, options), seed);
  compare(league, "b", b);
  compare_symmetric(league, "b", b);
  league.push_back(symmetric(random_symmetric(2 * b.size(), seed)).score("b", "dsyevd of a random 2n matrix", 2 * b.size()));
  compare(league, "c, stabilised", quadrature_indefinite(scaled_order(100, options), Balance::stabilised, seed));
  compare(league, "c, unstable roots", quadrature_indefinite(scaled_order(100, options), Balance::mixed, seed));
  return league;
}

}  // namespace gyromode::bench
