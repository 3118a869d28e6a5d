#include "gyromode/structure/inertia_of_k.h"

#include "gyromode/base/rounding.h"
#include "gyromode/lapack/indefinite.h"
#include "gyromode/lapack/symmetric.h"
#include "gyromode/lapack/triangular.h"
#include "gyromode/structure/ranked_factor.h"
#include "gyromode/system/scale.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace gyromode {

namespace {

// Up to the first order the rank is decided entry by entry. Beyond, a blocked factorisation decides where both its
// pivots and its condition estimate leave a factor 10 and more to the threshold (either alone can miss a null vector);
// else again entry by entry up to the second order, and the eigenvalues of the equilibrated K beyond that.
constexpr Index entry_by_entry_up_to = 64, singular_entry_by_entry_up_to = 256;

bool clearly_regular(double reciprocal_condition, const Vector& pivots) {
  const double n = static_cast<double>(pivots.size());
  const double ratio = pivots.cwiseAbs().minCoeff() / pivots.cwiseAbs().maxCoeff();
  return std::min(reciprocal_condition, ratio) > 100 * n * epsilon;
}

// Unit diagonal is as good as equilibration here: of all scalings it leaves a positive definite matrix within a factor
// n of the best condition (van der Sluis 1969).
std::optional<StiffnessInertia> positive_by_cholesky(const Matrix& k) {
  if (!(k.diagonal().array() > 0).all()) return std::nullopt;
  Vector scale = unit_diagonal_scale(k);
  Matrix l = scaled(k, scale);
  const double norm = norm1(l);
  if (lapack::cholesky(l)) return std::nullopt;
  const double rcond = lapack::reciprocal_condition(l, norm);
  if (!clearly_regular(rcond, l.diagonal().cwiseAbs2())) return std::nullopt;
  return StiffnessInertia{{0, 0}, k.rows(), Matrix(k.rows(), 0),
                          rcond,  false,    std::make_shared<const PositiveFactor>(PositiveFactor{std::move(scale), std::move(l)})};
}

std::optional<StiffnessInertia> regular_by_pivots(const Matrix& k) {
  const auto factor = lapack::factor_indefinite(k);
  const Vector d = lapack::pivot_values(factor);
  if ((d.array() == 0).any()) return std::nullopt;
  const double rcond = lapack::reciprocal_condition(factor, norm1(k));
  if (!clearly_regular(rcond, d)) return std::nullopt;
  const Index negative = (d.array() < 0).count();
  return StiffnessInertia{{negative, 0}, k.rows() - negative, Matrix(k.rows(), 0), rcond, false, {}};
}

// D v̂ of differing units point the same way. Gauss–Jordan elimination with complete pivoting makes the columns a unit
// matrix in some rows and at most about one in the others: independent to working precision, and every entry keeps its
// relative accuracy as far as subtraction lets it.
Matrix independent_columns(Matrix a) {
  std::vector<bool> used(static_cast<std::size_t>(a.rows()), false);
  for (Index k = 0; k < a.cols(); ++k) {
    a.rightCols(a.cols() - k).colwise().normalize();
    Index row = -1;
    Index column = k;
    for (Index j = k; j < a.cols(); ++j) {
      for (Index i = 0; i < a.rows(); ++i) {
        if (!used[static_cast<std::size_t>(i)] && (row < 0 || std::abs(a(i, j)) > std::abs(a(row, column)))) {
          row = i;
          column = j;
        }
      }
    }
    used[static_cast<std::size_t>(row)] = true;
    a.col(k).swap(a.col(column));
    a.col(k) /= a(row, k);
    for (Index j = 0; j < a.cols(); ++j) {
      if (j == k) continue;
      a.col(j) -= a(row, j) * a.col(k);
      a(row, j) = 0;
    }
  }
  a.colwise().normalize();
  return a;
}

StiffnessInertia by_eigenvalues(const Matrix& k, const Vector& scale) {
  const Index n = k.rows();
  StiffnessInertia result;
  const Vector values = lapack::symmetric_eigenvalues(k);
  const double largest = values.cwiseAbs().maxCoeff();
  const double threshold = zero_to_rounding(n) * largest;
  double smallest = largest;
  for (const double lambda : values) {
    if (std::abs(lambda) <= threshold) {
      ++result.zero;
    } else {
      ++(lambda < 0 ? result.negative : result.positive);
      smallest = std::min(smallest, std::abs(lambda));
    }
  }
  result.margin = result.zero < n ? smallest / largest : 0;
  result.doubtful = !(smallest > 8 * threshold);
  result.null_space.resize(n, result.zero);
  if (result.zero > 0) {  // K̂ v = 0 means K (D v) = 0. Zero eigenvalues stand together, after the negative ones.
    result.null_space =
        independent_columns(scale.asDiagonal() * lapack::symmetric_eigen(k).vectors.middleCols(result.negative, result.zero));
  }
  return result;
}

StiffnessInertia entry_by_entry(const Matrix& k) {
  RankedFactor f = ranked_factor(k);
  f.null_space.colwise().normalize();
  return {{f.negative, f.zero()}, f.positive, std::move(f.null_space), f.smallest_kept, f.doubtful(), {}};
}

StiffnessInertia of_nonzero_rows(const Matrix& k) {
  if (k.rows() <= entry_by_entry_up_to) return entry_by_entry(k);
  if (auto decided = positive_by_cholesky(k)) return *decided;
  const Vector scale = equilibrating_scale(k);
  const Matrix equilibrated = scaled(k, scale);
  if (auto decided = regular_by_pivots(equilibrated)) return *decided;
  return k.rows() <= singular_entry_by_entry_up_to ? entry_by_entry(k) : by_eigenvalues(equilibrated, scale);
}

}  // namespace

std::string_view to_string(Definiteness d) {
  switch (d) {
    case Definiteness::positive: return "positive";
    case Definiteness::semidefinite: return "semidefinite";
    default: return "indefinite";
  }
}

Definiteness InertiaOfK::definiteness() const {
  if (negative > 0) return Definiteness::indefinite;
  return zero > 0 ? Definiteness::semidefinite : Definiteness::positive;
}

StiffnessInertia inertia_of_k(const Matrix& k) {
  std::vector<Index> used;
  std::vector<Index> unused;  // rows of zeros: coordinates without stiffness, null vectors by themselves
  for (Index i = 0; i < k.rows(); ++i) (k.row(i).isZero(0) ? unused : used).push_back(i);
  if (unused.empty()) return k.rows() == 0 ? StiffnessInertia{} : of_nonzero_rows(k);
  StiffnessInertia d = used.empty() ? StiffnessInertia{} : of_nonzero_rows(k(used, used));
  Matrix null_space = Matrix::Zero(k.rows(), d.zero + static_cast<Index>(unused.size()));
  if (d.zero > 0) null_space.leftCols(d.zero)(used, Eigen::all) = d.null_space;
  for (std::size_t i = 0; i < unused.size(); ++i) null_space(unused[i], d.zero + static_cast<Index>(i)) = 1;
  d.zero = null_space.cols();
  d.null_space = std::move(null_space);
  return d;
}

}  // namespace gyromode
