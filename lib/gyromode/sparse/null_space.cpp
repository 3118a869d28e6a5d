#include "gyromode/sparse/null_space.h"

#include "gyromode/base/error.h"
#include "gyromode/lapack/multiply.h"
#include "gyromode/sparse/factor.h"
#include "gyromode/sparse/inverse_iteration.h"
#include "gyromode/sparse/lanczos.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gyromode::sparse {

namespace {

constexpr Index most_directions = 96;

// Eigenvectors about zero by |λ|, ascending: x (xᵀMx = 1), λ, and |x|ᵀ|A||x|.
struct About {
  Matrix x;
  Vector lambda, size;

  bool null(Index k) const { return std::abs(lambda(k)) <= singular_margin * size(k); }
};

// M-orthonormal columns, each against those before it, twice; without those of which nothing but rounding is left.
Matrix orthonormal_in_turn(Matrix x, const SparseMatrix& mass) {
  constexpr double rounding = 1e-12;
  Matrix mx(x.rows(), x.cols());
  Index kept = 0;
  for (Index j = 0; j < x.cols(); ++j) {
    Vector c = x.col(j);
    double before = std::sqrt(c.dot(symmetric_times(mass, c).col(0))), left = 1;
    c /= before;
    for (int pass = 0; pass < 2; ++pass) {
      c -= x.leftCols(kept) * (mx.leftCols(kept).transpose() * c);
      const double size = std::sqrt(c.dot(symmetric_times(mass, c).col(0)));
      left *= size;
      c /= size;
    }
    if (!(left > rounding)) continue;
    x.col(kept) = c;
    mx.col(kept++) = symmetric_times(mass, c);
  }
  return x.leftCols(kept);
}

// Block inverse iteration with A − μM, and every time a projection on what comes. Columns nearest to zero come first,
// so that the others, of which little is left beside them, are made orthogonal to these and not these to them.
About about_zero(SymmetricFactor& factor, const SparseMatrix& a, const SparseMatrix& mass, Index columns) {
  constexpr int steps = 5;
  constexpr unsigned draw = 11;
  About all;
  all.x = random_shapes(a.cols(), std::min(columns, a.cols()), draw);
  for (int step = 0; step < steps; ++step) {
    Matrix x = factor.solve(step == 0 ? all.x : symmetric_times(mass, all.x));
    if (!x.allFinite()) throw NotConverged("inverse iteration with a K that is singular to rounding has overflowed");
    x = orthonormal_in_turn(std::move(x), mass);
    const Eigen::SelfAdjointEigenSolver<Matrix> e(lapack::multiply_tn(x, symmetric_times(a, x)));
    std::vector<Index> order(static_cast<std::size_t>(e.eigenvalues().size()));
    std::iota(order.begin(), order.end(), Index{0});
    std::sort(order.begin(), order.end(), [&](Index i, Index k) { return std::abs(e.eigenvalues()(i)) < std::abs(e.eigenvalues()(k)); });
    all.lambda = e.eigenvalues()(order);
    all.x = x * Matrix(e.eigenvectors()(Eigen::all, order));
  }
  all.size = sizes_of(a, all.x.cwiseAbs());
  return all;
}

SparseMatrix shifted(const SparseMatrix& a, double mu, const SparseMatrix& mass) { return a - mu * mass; }

}  // namespace

NullSpace null_space_of(const SparseMatrix& a, const SparseMatrix& mass, const std::vector<int>& order) {
  // A shift of 10⁻¹⁰ of what stiffness is to mass keeps solves apart from rounding; that of the counts comes of it.
  constexpr double first_shift = 1e-10, apart = 100;
  const double sum = a.diagonal().cwiseAbs().sum(), stiff = (sum > 0 ? sum : 1) / mass.diagonal().sum();
  NullSpace n;
  SymmetricFactor solves(shifted(a, 1, mass), order, SymmetricFactor::Keep::factors);
  solves.factor(shifted(a, first_shift * stiff, mass));
  for (Index columns = 8; n.basis.cols() == 0; columns *= 2) {
    const About near = about_zero(solves, a, mass, columns);
    Index r = 0;
    double rounding = 0;
    while (r < near.lambda.size() && near.null(r)) rounding = std::max(rounding, singular_margin * near.size(r++));
    if (r == near.lambda.size() && r < a.cols()) {  // more may come
      if (columns >= most_directions)
        throw NotApplicable(fmt::format("K is singular in more than {} directions: hold what is not held", columns));
      continue;
    }
    n.next = r < near.lambda.size() ? std::abs(near.lambda(r)) : infinity;
    n.shift = r < near.lambda.size() ? std::sqrt(rounding * n.next) : std::max(apart * rounding, first_shift * stiff);
    if (n.next < apart * rounding)
      throw NotApplicable(
          fmt::format("K is singular to rounding in {} directions, and ω² = {:.3g} of another one comes too near to that: "
                      "which motions are free cannot be told",
                      r, n.next));
    SymmetricFactor counts(shifted(a, 1, mass), order, SymmetricFactor::Keep::counts);
    const Index below = counts.factor(shifted(a, n.shift, mass));
    n.negative = counts.factor(shifted(a, -n.shift, mass));
    if (below - n.negative == r) {
      n.basis = near.x.leftCols(r);
      return n;
    }
    if (columns >= most_directions || below - n.negative < r)
      throw NotApplicable(
          fmt::format("K is singular to rounding in {} directions where counts on both sides of zero make {}: which motions "
                      "are free cannot be told",
                      r, below - n.negative));
  }
  return n;
}

}  // namespace gyromode::sparse
