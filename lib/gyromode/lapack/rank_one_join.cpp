#include "gyromode/lapack/rank_one_join.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/status.h"
#include "gyromode/lapack/team.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

// Parts of dstedc that LAPACKE leaves out.
extern "C" {
void dlaed2_(int* k, const int* n, const int* n1, double* d, double* q, const int* ldq, int* indxq, double* rho, double* z, double* dlamda,
             double* w, double* q2, int* indx, int* indxc, int* indxp, int* coltyp, int* info);
void dlaed4_(const int* n, const int* i, const double* d, const double* z, double* delta, const double* rho, double* dlam, int* info);
}

namespace gyromode::lapack {

namespace {

using Integers = std::vector<int>;

// What is left after deflation: δ_i + ρ z_i²/… of order k, and the old vectors by the halves in which they are not
// zero.
struct Deflated {
  Index k = 0;
  double rho = 0;
  Vector delta, z;  // poles, ascending, and weights
  Vector q2;        // old vectors: cut × (upper + both), then (n − cut) × (both + lower), then the deflated ones
  Integers order;   // row i of the new vectors belongs to pole order[i] − 1
  Index upper = 0, both = 0, lower = 0;
};

Deflated deflated(Vector& d, Matrix& q, Index cut, double rho) {
  const Index n = d.size();
  const std::size_t size = static_cast<std::size_t>(n);
  Integers ascending(size), index(size), place(size);
  Integers type(std::max<std::size_t>(size, 4));  // on return how many columns are of each of four types
  std::iota(ascending.begin(), ascending.begin() + cut, 1);
  std::iota(ascending.begin() + cut, ascending.end(), 1);
  Vector row(n);
  row << q.row(cut - 1).head(cut).transpose(), q.row(cut).tail(n - cut).transpose();
  Deflated r{0, rho, Vector(n), Vector(n), Vector(n * n), Integers(size), 0, 0, 0};
  const int order = dimension(n, "dlaed2");
  const int at = static_cast<int>(cut);
  int k = 0;
  int info = 0;
  dlaed2_(&k, &order, &at, d.data(), q.data(), &order, ascending.data(), &r.rho, row.data(), r.delta.data(), r.z.data(), r.q2.data(),
          index.data(), r.order.data(), place.data(), type.data(), &info);
  require_success(info, "dlaed2", "");
  r.k = k;
  r.upper = type[0];
  r.both = type[1];
  r.lower = type[2];
  return r;
}

// Roots of the secular equation into d(0 … k − 1). Returns the vectors of the rank-one problem, rows in the order of
// the old vectors, from the weights for which the computed roots are exact (Löwner's formula): they are orthogonal
// however close the roots are.
Matrix solve_secular(const Deflated& r, Vector& d, Team& team) {
  const Index k = r.k;
  Matrix distance(k, k);  // δ_i − λ_j
  Matrix product = Matrix::Ones(k, team.size());
  std::vector<int> infos(static_cast<std::size_t>(team.size()), 0);
  const auto each = [&](int part, const auto& work) {
    for (Index j = team.begin(k, part); j < team.begin(k, part + 1); ++j) work(j);
  };
  team.run([&](int part) {
    auto share = product.col(part).array();
    each(part, [&](Index j) {
      const int order = static_cast<int>(k);
      const int which = static_cast<int>(j) + 1;
      int info = 0;
      dlaed4_(&order, &which, r.delta.data(), r.z.data(), &distance(0, j), &r.rho, &d(j), &info);
      if (info != 0) infos[static_cast<std::size_t>(part)] = info;
      if (k <= 2) return;
      const double own = share(j);
      share *= distance.col(j).array() / (r.delta.head(k).array() - r.delta(j));
      share(j) = own * distance(j, j);
    });
  });
  for (const int info : infos) require_success(info, "dlaed4", "a root of the secular equation did not converge");
  Matrix vectors(k, k);
  const Vector weight = (-product.rowwise().prod()).cwiseSqrt().cwiseProduct(r.z.head(k).cwiseSign());
  team.run([&](int part) {
    Vector x(k);
    each(part, [&](Index j) {
      if (k <= 2) {
        x = distance.col(j);  // dlaed4 gives the vector itself
      } else {
        x = weight.cwiseQuotient(distance.col(j));
        x /= x.norm();
      }
      for (Index i = 0; i < k; ++i) vectors(i, j) = x(r.order[static_cast<std::size_t>(i)] - 1);
    });
  });
  return vectors;
}

// The first k columns of q: old vectors times new ones, half by half.
void transform(const Deflated& r, const Matrix& vectors, Index cut, Matrix& q) {
  const Index rest = q.rows() - cut;
  const Index in_first = r.upper + r.both;
  const Index in_second = r.both + r.lower;
  const Eigen::Map<const Matrix> first(r.q2.data(), cut, in_first);
  const Eigen::Map<const Matrix> second(r.q2.data() + cut * in_first, rest, in_second);
  multiply_into(q.topLeftCorner(cut, r.k), 1, first, false, vectors.topRows(in_first), false, 0);
  multiply_into(q.bottomLeftCorner(rest, r.k), 1, second, false, vectors.bottomRows(in_second), false, 0);
}

}  // namespace

void join_rank_one(Vector& d, Matrix& q, Index cut, double rho) {
  const Deflated r = deflated(d, q, cut, rho);
  if (r.k > 0) {
    Matrix vectors;
    {
      Team team(threads_for(r.k));
      vectors = solve_secular(r, d, team);
    }
    transform(r, vectors, cut, q);
  }
  Integers ascending(static_cast<std::size_t>(d.size()));
  std::iota(ascending.begin(), ascending.end(), 0);
  std::sort(ascending.begin(), ascending.end(), [&](int a, int b) { return d(a) < d(b); });
  if (std::is_sorted(ascending.begin(), ascending.end())) return;
  d = d(ascending).eval();
  Matrix sorted(q.rows(), q.cols());
  Team team(threads_for(q.cols()));
  team.run([&](int part) {
    for (Index j = team.begin(q.cols(), part); j < team.begin(q.cols(), part + 1); ++j)
      sorted.col(j) = q.col(ascending[static_cast<std::size_t>(j)]);
  });
  q = std::move(sorted);
}

}  // namespace gyromode::lapack
