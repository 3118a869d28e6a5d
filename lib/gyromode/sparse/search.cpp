#include "gyromode/sparse/search.h"

#include "gyromode/sparse/matrix.h"

#include "gyromode/base/error.h"
#include "gyromode/base/rounding.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace gyromode::sparse {

namespace {

constexpr Index block = 8;  // widths of 4 and 16 are slower (theory sparse §2)

Matrix random_shapes(Index n) {
  std::mt19937_64 bits(20090);  // the same for every machine
  Matrix x(n, block);
  for (Index j = 0; j < block; ++j) {
    for (Index i = 0; i < n; ++i) x(i, j) = std::ldexp(static_cast<double>(bits() >> 11), -52) - 1;
  }
  return x;
}

}  // namespace

double size_of(const SparseMatrix& lower, const ComplexVector& x) {
  const Vector size = x.cwiseAbs();
  double sum = 0;
  for (Index j = 0; j < lower.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator it(lower, j); it; ++it)
      sum += (it.row() == j ? 1 : 2) * std::abs(it.value()) * size(it.row()) * size(j);
  }
  return sum;
}

Search::Search(const SparseSystem& system, ShiftedImpedance& impedance, const Norms& norms, double sigma)
    : system_(system),
      norms_(norms),
      negative_(impedance.factor(sigma)),
      v_(std::make_unique<Subspace>(system, impedance.in_quadrature(), impedance.quadrature())) {
  krylov_ = std::make_unique<Krylov>(system, impedance, *v_, random_shapes(system.size()));
}

bool Search::converged(const RitzMode& m) {
  constexpr double enough = 1e-11;  // a tenth of what is asked of a result
  return m.residual <= enough;
}

Search::Found Search::found(double below) const {
  const RitzPairs pairs = ritz_pairs(*v_);
  std::vector<Index> chosen;
  for (Index k = 0; k < pairs.omega.size() && pairs.omega(k) < below; ++k) chosen.push_back(k);
  Found f;
  f.modes = measured(system_, norms_, *v_, pairs, chosen);
  for (std::size_t k = 0; k < f.modes.size(); ++k) {
    RitzMode& m = f.modes[k];
    constexpr double rounding = 4 * epsilon;
    const double w = m.omega;
    m.error_bound +=
        rounding *
        (size_of(system_.stiffness(), m.shape) + w * size_of(system_.gyroscopic(), m.shape) + w * w * size_of(system_.mass(), m.shape)) /
        std::abs(m.form);
  }
  for (Index k = 0; k < pairs.unstable.count(); ++k) {
    const Complex lambda = pairs.unstable.lambda[static_cast<std::size_t>(k)];
    const ComplexVector c = pairs.unstable.right.col(k), d = pairs.unstable.left.col(k);
    Matrix parts(c.size(), 4);
    parts << c.real(), c.imag(), d.real(), d.imag();
    const Matrix x = v_->combined(parts), mx = v_->mass_times(parts), kx = symmetric_times(system_.stiffness(), x),
                 gx = skew_times(system_.gyroscopic(), x);
    const auto joined = [](const Matrix& a, Index at) { return ComplexVector(a.col(at) + Complex(0, 1) * a.col(at + 1)); };
    const ComplexVector shape = joined(x, 0), left = joined(x, 2);
    const ComplexVector r = joined(kx, 0) + lambda * joined(gx, 0) + lambda * lambda * joined(mx, 0);
    const double size = std::abs(lambda);
    const Complex slope = left.dot(2.0 * lambda * joined(mx, 0) + joined(gx, 0));
    f.unstable.push_back({lambda, r.norm() / ((norms_.k + size * norms_.g + size * size * norms_.m) * shape.norm()),
                          r.norm() * left.norm() / std::abs(slope), shape});
  }
  return f;
}

Search::Found Search::until(const std::function<bool(const Found&)>& enough, double below, Index largest, const Progress& progress) {
  constexpr int steps_between = 3, most_idle = 4;
  Index best = 0;
  int idle = 0;  // looks without a mode more that has converged
  for (int step = 1;; ++step) {
    const bool more = krylov_->step();
    if (progress.stopped()) throw Interrupted();
    if (more && step % steps_between != 0 && v_->size() < largest) continue;
    Found f = found(below);
    Index good = 0;
    for (const RitzMode& m : f.modes) good += converged(m) ? 1 : 0;
    progress.report("modes", good, static_cast<Index>(f.modes.size()));
    idle = good > best ? 0 : idle + 1;
    best = std::max(best, good);
    if (enough(f) || !more || idle >= most_idle || v_->size() >= largest) return f;
  }
}

}  // namespace gyromode::sparse
