#include "gyromode/sweep/projected_family.h"

#include "gyromode/sparse/matrix.h"

#include <cmath>

namespace gyromode {

ProjectedFamily::ProjectedFamily(const LargeFamily& family, double reach) : family_(family), tau_(reach * reach) {
  const Index n = family.mass.cols();
  basis_ = weighted_basis_ = Matrix(n, 0);
  reduced_ = {Matrix(0, 0), Matrix(0, 0), Matrix(0, 0), Matrix(0, 0), Matrix(0, 0), {}, {}};
}

Matrix ProjectedFamily::weighted(const Matrix& x) const {
  return sparse::symmetric_times(family_.stiffness, x) + tau_ * sparse::symmetric_times(family_.mass, x);
}

ComplexMatrix ProjectedFamily::coordinates(const ComplexMatrix& x) const {
  const Matrix re = weighted_basis_.transpose() * x.real(), im = weighted_basis_.transpose() * x.imag();
  ComplexMatrix y(re.rows(), re.cols());
  y.real() = re;
  y.imag() = im;
  return y;
}

// Gram and Schmidt, twice, in the scalar product of S. Parts of a shape that are rounding of it are no directions.
void ProjectedFamily::add(const ComplexMatrix& shapes) {
  constexpr double known = 1e-6;
  const Index before = basis_.cols();
  Index size = before;
  const Index most = before + 2 * shapes.cols();
  basis_.conservativeResize(Eigen::NoChange, most);
  weighted_basis_.conservativeResize(Eigen::NoChange, most);
  for (Index k = 0; k < shapes.cols(); ++k) {
    const Matrix parts = sparse::parts_of(shapes.col(k)), sizes = parts.cwiseProduct(weighted(parts)).colwise().sum();
    const double whole = std::sqrt(sizes.sum());
    for (Index part = 0; part < 2; ++part) {
      Vector v = parts.col(part) / whole;
      bool is_new = true;
      for (int pass = 0; pass < 2 && is_new; ++pass) {
        v -= basis_.leftCols(size) * (weighted_basis_.leftCols(size).transpose() * v);
        const double left = std::sqrt(std::max(0.0, v.dot(weighted(v).col(0))));
        is_new = left > known;
        if (is_new) v /= left;
      }
      if (!is_new) continue;
      basis_.col(size) = v;
      weighted_basis_.col(size++) = weighted(v);
    }
  }
  basis_.conservativeResize(Eigen::NoChange, size);
  weighted_basis_.conservativeResize(Eigen::NoChange, size);
  if (size > before) add_to_family(basis_.rightCols(size - before));
}

// The rows and columns of the reduced matrices that belong to the last columns of V.
void ProjectedFamily::add_to_family(const Matrix& more) {
  const Index all = basis_.cols(), fresh = more.cols(), before = all - fresh;
  const auto grow = [&](Matrix& a, const Matrix& product, double sign) {
    const Matrix columns = basis_.transpose() * product;
    const Matrix corner = columns.bottomRows(fresh);
    a.conservativeResize(all, all);
    a.topRightCorner(before, fresh) = columns.topRows(before);
    a.bottomLeftCorner(fresh, before) = sign * columns.topRows(before).transpose();
    a.bottomRightCorner(fresh, fresh) = 0.5 * (corner + sign * corner.transpose());
  };
  grow(reduced_.mass, sparse::symmetric_times(family_.mass, more), 1);
  grow(reduced_.stiffness, sparse::symmetric_times(family_.stiffness, more), 1);
  grow(reduced_.stiffness_per_spin2, sparse::symmetric_times(family_.stiffness_per_spin2, more), 1);
  grow(reduced_.gyroscopic_per_spin, sparse::skew_times(family_.gyroscopic_per_spin, more), -1);
  reduced_.gyroscopic = Matrix::Zero(all, all);
}

}  // namespace gyromode
