#include "gyromode/models/mesh_free_motions.h"

#include "gyromode/sparse/matrix.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace gyromode {

namespace {

// ‖y‖ of y = Kx − what it should be, relative to |x|ᵀ|K||x|, of every column.
Vector departures(const SparseMatrix& k, const Matrix& x, const Matrix& y) {
  const Vector diagonal = k.diagonal().cwiseAbs().cwiseMax(1e-300), sizes = sparse::sizes_of(k, x.cwiseAbs());
  Vector all(x.cols());
  for (Index j = 0; j < x.cols(); ++j) all(j) = std::sqrt(y.col(j).cwiseAbs2().cwiseQuotient(diagonal).sum() / std::max(sizes(j), 1e-300));
  return all;
}

constexpr double rounding_of_file = 1e-11;

}  // namespace

Matrix free_translations(const StructureParts& p) {
  constexpr double across = 1e-9;
  const Eigen::Vector3d axis = Eigen::Vector3d(p.axis[0], p.axis[1], p.axis[2]).normalized();
  Eigen::Vector3d first = axis.unitOrthogonal();
  for (int d = 2; d >= 0; --d) {
    if (std::abs(axis(d)) <= across) first = Eigen::Vector3d::Unit(d);
  }
  const Eigen::Vector3d second = axis.cross(first);
  Matrix t(p.mass.cols(), 2);
  for (Index k = 0; k < t.rows(); ++k) {
    const int d = p.coordinates[static_cast<std::size_t>(k)].direction;
    t.row(k) << first(d), second(d);
  }
  const Matrix held = sparse::symmetric_times(p.stiffness, t) + p.spin * p.spin * sparse::symmetric_times(p.mass, t);
  return departures(p.stiffness, t, held).maxCoeff() > rounding_of_file ? Matrix(t.rows(), 0) : t;
}

Matrix free_along_axis(const StructureParts& p) {
  const Eigen::Vector3d axis = Eigen::Vector3d(p.axis[0], p.axis[1], p.axis[2]).normalized();
  const auto centre = centre_of(p);
  const Eigen::Vector3d middle =
      centre ? Eigen::Vector3d((*centre)[0], (*centre)[1], (*centre)[2]) : Eigen::Vector3d(Eigen::Vector3d::Zero());
  Matrix r = Matrix::Zero(p.mass.cols(), centre ? 2 : 1);
  for (Index k = 0; k < r.rows(); ++k) {
    const int d = p.coordinates[static_cast<std::size_t>(k)].direction;
    r(k, 0) = axis(d);
    if (!centre) continue;
    const auto& at = p.positions[static_cast<std::size_t>(k)];
    r(k, 1) = axis.cross(Eigen::Vector3d(at[0], at[1], at[2]) - middle)(d);
  }
  const Vector off = departures(p.stiffness, r, sparse::symmetric_times(p.stiffness, r));
  std::vector<Index> there;
  for (Index k = 0; k < r.cols(); ++k) {
    if (r.col(k).squaredNorm() > 0 && off(k) <= rounding_of_file) there.push_back(k);
  }
  return r(Eigen::all, there);
}

}  // namespace gyromode
