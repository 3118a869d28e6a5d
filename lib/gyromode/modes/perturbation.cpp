#include "gyromode/modes/perturbation.h"

#include "gyromode/lapack/multiply.h"
#include "gyromode/lapack/small.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace gyromode {

namespace {

int order_of(const std::string& matrix, bool first_order) {
  if (matrix == "M") return 2;
  return matrix == "I" || (matrix == "G" && !first_order) ? 1 : 0;
}

// The eigenvalues of diag(λ_k − λ₀) + B of a few roots, against λ_k − λ₀: the largest distance, paired in order.
double largest_distance(const ComplexVector& lambda, const ComplexMatrix& b) {
  const ComplexVector before = lambda.array() - lambda.mean();
  const ComplexVector after = small::schur(ComplexMatrix(before.asDiagonal()) + b).t.diagonal();
  const auto in_order = [](const ComplexVector& z) {
    std::vector<Complex> all(z.begin(), z.end());
    std::sort(all.begin(), all.end(), [](Complex p, Complex q) { return p.imag() < q.imag(); });
    return all;
  };
  const auto p = in_order(before), q = in_order(after);
  double most = 0;
  for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::abs(p[k] - q[k]));
  return most;
}

}  // namespace

// Rows and columns of the roots chosen tell which others are near to them; theirs are formed then, too.
Perturbation::Perturbation(const RootVectors& roots, const Repair& repair, bool first_order, const std::vector<Index>& chosen)
    : roots_(roots),
      repair_(repair),
      order_(order_of(repair.matrix, first_order)),
      parity_(repair.matrix == "G" ? 1 : -1),
      norm_(repair.dropped->norm()),
      length_((roots.parts().leftCols(roots.columns()).colwise().squaredNorm() +
               roots.parts().rightCols(roots.columns()).colwise().squaredNorm())
                  .cwiseSqrt()),
      place_(static_cast<std::size_t>(roots.columns()), -1) {
  if (roots.whole()) of_massless_ = (*repair.dropped)(roots.whole()->massless, Eigen::all);
  form_products(chosen);
  std::set<Index> wanted(chosen.begin(), chosen.end());
  for (const Index i : chosen) {
    for (const Index k : near(i)) wanted.insert(k);
  }
  const auto all_formed = [this](Index k) { return is_formed(roots_.root(k)); };
  if (!std::all_of(wanted.begin(), wanted.end(), all_formed)) form_products({wanted.begin(), wanted.end()});
}

bool Perturbation::is_formed(const RootPlace& r) const {
  return place_[static_cast<std::size_t>(r.right.column)] >= 0 && place_[static_cast<std::size_t>(r.left.column)] >= 0;
}

void Perturbation::form_products(const std::vector<Index>& chosen) {
  std::set<Index> columns;
  for (const Index i : chosen) columns.insert({roots_.root(i).right.column, roots_.root(i).left.column});
  places_ = static_cast<Index>(columns.size());
  const Matrix& parts = roots_.parts();
  Matrix of_columns(parts.rows(), 2 * places_);
  Index at = 0;
  for (const Index c : columns) {
    place_[static_cast<std::size_t>(c)] = at;
    of_columns.col(at) = parts.col(c);
    of_columns.col(places_ + at++) = parts.col(roots_.columns() + c);
  }
  products_ = lapack::multiply_tn(parts, lapack::multiply(*repair_.dropped, of_columns));
}

// yᴴ D x with the column of x formed: the four products of the parts.
Complex Perturbation::formed(const VectorPlace& y, const VectorPlace& x) const {
  const Index at = place_[static_cast<std::size_t>(x.column)], im = roots_.columns();
  const double rr = products_(y.column, at), ii = products_(im + y.column, places_ + at);
  const double ri = products_(y.column, places_ + at), ir = products_(im + y.column, at);
  return {rr + y.sign() * x.sign() * ii, x.sign() * ri - y.sign() * ir};
}

// yᴴ D x = parity·x̄ᴴ D ȳ.
Complex Perturbation::product(const VectorPlace& y, const VectorPlace& x) const {
  return place_[static_cast<std::size_t>(x.column)] >= 0 ? formed(y, x) : parity_ * formed(x.conjugated(), y.conjugated());
}

Complex Perturbation::power(Complex lambda) const { return order_ == 2 ? lambda * lambda : order_ == 1 ? lambda : 1; }

Complex Perturbation::b(Index k, Index l, Complex power_at) const {
  return -power_at * product(roots_.root(k).left, roots_.root(l).right) / roots_.root(k).slope;
}

// |y_kᴴ D x_k| / |d_k|; where the column is not formed no less than that, by norms.
double Perturbation::own(Index k) const {
  const RootPlace& r = roots_.root(k);
  if (is_formed(r)) return std::abs(product(r.left, r.right) / r.slope);
  return norm_ * length_(r.left.column) * length_(r.right.column) / std::abs(r.slope);
}

// Those that the second order would leave open beyond a thousandth; where that is half of a large spectrum, as a large
// part that was asked to be dropped makes it, those that it would leave open beyond a twentieth.
std::vector<Index> Perturbation::near(Index i) const {
  constexpr std::size_t largest_block = 64;
  std::vector<Index> all = near(i, 2000);
  return all.size() <= largest_block ? all : near(i, 20);
}

std::vector<Index> Perturbation::near(Index i, double apart) const {
  const Complex lambda = roots_.root(i).lambda, p = power(lambda);
  std::vector<Index> all{i};
  for (Index k = 0; k < roots_.count(); ++k) {
    if (k == i) continue;
    const double distance = std::abs(lambda - roots_.root(k).lambda);
    if (distance * distance <= 20 * apart * std::abs(b(i, k, p) * b(k, i, p)) || distance <= apart * std::abs(p) * (own(i) + own(k))) {
      all.push_back(k);
    }
  }
  return all;
}

// yᴴD C Dx / d, C the compliance at infinity: what roots at infinity add in second order.
Complex Perturbation::by_massless(Index i) const {
  if (!roots_.whole()) return 0;
  const auto seen = [&](const VectorPlace& v) {
    const Matrix& parts = roots_.parts();
    const Vector re = of_massless_ * parts.col(v.column), im = of_massless_ * parts.col(roots_.columns() + v.column);
    return ComplexVector(re + Complex(0, v.sign()) * im);
  };
  const RootPlace& r = roots_.root(i);
  const ComplexVector right = seen(r.right), left = seen(r.left);
  return parity_ * left.dot(roots_.whole()->compliance_at_infinity * right) / r.slope;
}

double Perturbation::moves(Index i, Complex by_others) const {
  const Complex lambda = roots_.root(i).lambda, p = power(lambda);
  const std::vector<Index> together = near(i);
  Complex far = by_others + p * p * by_massless(i);
  std::size_t next = 1;  // of those together, the first of which is i
  for (Index k = 0; k < roots_.count(); ++k) {
    if (k == i) continue;
    if (next < together.size() && together[next] == k) {
      ++next;
    } else {
      far += b(i, k, p) * b(k, i, p) / (lambda - roots_.root(k).lambda);
    }
  }
  if (together.size() == 1) return std::abs(b(i, i, p) + far);
  const Index count = static_cast<Index>(together.size());
  ComplexVector lambdas(count);
  ComplexMatrix block(count, count);
  for (Index k = 0; k < count; ++k) {
    const Index from = together[static_cast<std::size_t>(k)];
    lambdas(k) = roots_.root(from).lambda;
    for (Index l = 0; l < count; ++l) block(k, l) = b(from, together[static_cast<std::size_t>(l)], p);
  }
  return largest_distance(lambdas, block) + std::abs(far);
}

}  // namespace gyromode
